// Where a part of the page shows itself.

/** It is named by the heading that is called after the part. @param {string} name @param {string} [id] */
export function createSection(name, id = name) {
  const section = document.createElement('section');
  Object.assign(section, { id, className: `part-section ${name}` });
  section.dataset.page = name;
  section.setAttribute('aria-labelledby', `${name}-title`);
  return section;
}
