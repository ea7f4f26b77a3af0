/**
 * Copies what a field holds, and returns what is said of it; where the browser lets no page copy, the text is selected for the keyboard.
 * @param {string} id @param {string} copied @param {string} notCopied
 */
export async function copy(id, copied, notCopied) {
  const field = /** @type {HTMLInputElement | HTMLTextAreaElement} */ (document.getElementById(id));
  try {
    await navigator.clipboard.writeText(field.value);
    return copied;
  } catch {
    field.focus();
    return notCopied;
  }
}
