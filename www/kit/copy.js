/**
 * Copies what a field holds, and says so; where the browser lets no page copy, the text is selected for the keyboard.
 * @param {HTMLInputElement | HTMLTextAreaElement} field @param {HTMLElement} status @param {{ copied: string, notCopied: string }} words
 */
export async function copy(field, status, { copied, notCopied }) {
  try {
    await navigator.clipboard.writeText(field.value);
    status.textContent = copied;
  } catch {
    field.focus();
    status.textContent = notCopied;
  }
}
