// A choice of one among a few: native radio buttons that look like one control.

/** @template {string} V @typedef {{ value: V, text: string, hint?: string }} Choice */

/**
 * @template {string} V
 * @param {HTMLFieldSetElement} fieldset @param {string} legend
 * @param {readonly Choice<V>[]} choices @param {(value: V) => void} onChoose
 */
export function createSegmented(fieldset, legend, choices, onChoose) {
  const title = document.createElement('legend');
  title.textContent = legend;
  title.className = 'visually-hidden';
  const inputs = choices.map(({ value, text, hint }) => {
    const label = document.createElement('label');
    const input = document.createElement('input');
    const face = document.createElement('span');
    Object.assign(input, { type: 'radio', name: fieldset.id, value, id: `${fieldset.id}-${value}` });
    input.addEventListener('change', () => onChoose(value));
    face.textContent = text;
    if (hint) label.title = hint;
    label.append(input, face);
    return { value, label, input };
  });
  fieldset.replaceChildren(title, ...inputs.map(({ label }) => label));
  return {
    /** @param {V} chosen */
    draw(chosen) {
      for (const { value, input } of inputs) input.checked = value === chosen;
    },
  };
}
