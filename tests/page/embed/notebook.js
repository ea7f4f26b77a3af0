// A notebook's page, which has a widget as anywidget has it.

/** @typedef {import('../harness/browsers.js').Page} Page */

/** In the page: what anywidget gives to a widget, as its documentation describes it. */
export const notebook = `<div id="cell"></div><script>
  const listeners = [];
  const changed = new Set();
  sent = {};
  model = {
    values: {},
    get: (name) => model.values[name],
    set(name, value) {
      model.values[name] = value;
      changed.add(name);
    },
    save_changes() {
      for (const name of changed) sent[name] = model.values[name];
      changed.clear();
    },
    on: (name, hear) => listeners.push({ name, hear }),
    off: (name, hear) => listeners.splice(listeners.findIndex((one) => one.name === name && one.hear === hear), 1),
  };
  // What comes from Python.
  receive = (traits) => {
    const news = Object.keys(traits).filter((name) => JSON.stringify(traits[name]) !== JSON.stringify(model.values[name]));
    Object.assign(model.values, traits);
    for (const { name, hear } of [...listeners]) if (news.includes(name.slice('change:'.length))) hear();
  };
  show = async ({ _esm, _page, ...traits }) => {
    const bytes = Uint8Array.from(atob(_page), (one) => one.charCodeAt(0));
    receive({ ...traits, _page: new DataView(bytes.buffer) });
    const { default: widget } = await import(URL.createObjectURL(new Blob([_esm], { type: 'text/javascript' })));
    leave = await widget.render({ model, el: cell });
  };
</script>`;

/** What the widget has sent to Python, once it fulfils a condition. As text, for one driver changes the last digit of some numbers. @param {Page} page @param {string} condition on `sent` */
export const sentBy = async (page, condition) =>
  JSON.parse(
    await page.until(
      condition,
      (text) => {
        const sent = Reflect.get(window, 'sent');
        return new Function('sent', `return ${text}`)(sent) && JSON.stringify(sent);
      },
      condition,
    ),
  );

/** @param {Page} page @param {'show' | 'receive'} how @param {Record<string, any>} traits */
export const give = (page, how, traits) =>
  page.evaluate((name, values) => Reflect.get(window, name)(values), how, traits);

/** The newest state is that of so many generations. @param {number} count */
export const has = (count) =>
  `sent._statistics?.length === ${count + 1} && sent.state.generations === ${count}`;
