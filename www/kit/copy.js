/**
 * Copies what a field or an element holds, and returns what is said of it; where the browser lets no page copy, the text is selected for the keyboard.
 * @param {string} id @param {string} copied @param {string} notCopied
 */
export async function copy(id, copied, notCopied) {
  const field = /** @type {HTMLElement} */ (document.getElementById(id));
  try {
    const value = 'value' in field ? String(field.value) : (field.textContent ?? '');
    await navigator.clipboard.writeText(value);
    return copied;
  } catch {
    field.focus();
    // A field does so by itself.
    if (!('value' in field)) getSelection()?.selectAllChildren(field);
    return notCopied;
  }
}
