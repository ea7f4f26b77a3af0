// The figure in a notebook. The text of dist/embed.js stands before this one and defines the element <ep-locomotion>.

/** A running evolution is told to Python no more often, in milliseconds. */
const pause = 250;

/** The figure takes no more generations at once. */
const mostAtOnce = 10_000;

/** Whether it has fields of its own. @param {unknown} value */
const isObject = (value) => typeof value === 'object' && value !== null && !Array.isArray(value);

/** An experiment, or a part of one, with some fields other. @param {any} whole @param {any} fields @returns {any} */
function changed(whole, fields) {
  const copy = { ...whole };
  for (const [name, value] of Object.entries(fields))
    copy[name] = isObject(value) && isObject(whole[name]) ? changed(whole[name], value) : value;
  return copy;
}

/** The page, which Python has sent along. @param {DataView<ArrayBuffer>} packed @returns {Promise<Blob>} */
function unpacked(packed) {
  const text = new Blob([packed]).stream().pipeThrough(new DecompressionStream('gzip'));
  return new Response(text, { headers: { 'Content-Type': 'text/html' } }).blob();
}

/** @param {{ model: any, el: HTMLElement }} view as anywidget gives it */
async function render({ model, el }) {
  const page = URL.createObjectURL(await unpacked(model.get('_page')));
  /** @type {any} What it can do stands in www/embed/element.js. */
  const figure = document.createElement('ep-locomotion');
  Object.assign(figure, { src: page, link: model.get('link') });

  // What Python asks in vain is said in sight too.
  const refusal = document.createElement('p');
  refusal.setAttribute('role', 'alert');

  /** The statistics of every generation that the figure has. @type {any[]} */
  const history = [];
  /** @type {ReturnType<typeof setTimeout> | undefined} */
  let timer;
  const tell = () => {
    clearTimeout(timer);
    timer = undefined;
    model.set('_statistics', [...history]);
    model.save_changes();
  };

  figure.addEventListener('generation', (/** @type {CustomEvent} */ { detail }) => {
    // Generation 0 begins anew.
    history.length = detail.generation;
    history.push(detail);
    timer ||= setTimeout(tell, pause);
  });
  for (const type of ['ready', 'state'])
    figure.addEventListener(type, (/** @type {CustomEvent} */ { detail }) => {
      model.set('state', detail);
      tell();
    });
  figure.addEventListener('error', (/** @type {CustomEvent} */ { detail }) => {
    model.set('error', detail.message);
    model.save_changes();
  });

  // One after the other: how many generations are missing is known once what was asked before is answered.
  let last = Promise.resolve();
  const inTurn = (/** @type {() => Promise<void>} */ task) => {
    last = last.then(task).catch(({ message }) => {
      refusal.textContent = message;
    });
  };
  /** How many are to come at once. */
  const missing = () => Math.min(model.get('_wanted') - (history.length - 1), mostAtOnce);
  const advance = async () => {
    for (let count = missing(); count > 0; count = missing()) {
      const wanted = history.length + count;
      await figure.step(count);
      // Who sits before the figure has stopped it.
      if (history.length < wanted) return;
    }
  };
  const complain = (/** @type {string} */ message) => {
    refusal.textContent = message;
    model.set('error', message);
    model.save_changes();
  };
  /** The same run, with the robot that these gains drive; without any, that of the generation. */
  const drive = async () => {
    const { experiment, generations: generation } = figure.state;
    const gains = model.get('gains') ?? undefined;
    await figure.set({ experiment, gains, generation });
  };
  const begin = async () => {
    complain('');
    // Once all of it is there.
    const { experiment, problems } = await figure.set({ link: model.get('link') });
    complain(problems.join(' '));
    const fields = model.get('experiment');
    if (Object.keys(fields).length > 0) await figure.set({ experiment: changed(experiment, fields) });
    if (model.get('gains')) await drive();
    await advance();
  };
  const driveAnew = async () => {
    complain('');
    await drive();
  };
  /** How many are to begin, or to come as far as Python wants them. */
  let beginning = 0;
  const beginInTurn = () => {
    beginning += 1;
    inTurn(() =>
      begin().finally(() => {
        beginning -= 1;
      }),
    );
  };
  const advanceInTurn = () => inTurn(advance);
  const driveInTurn = () => inTurn(driveAnew);

  el.append(refusal, figure);
  beginInTurn();
  // What was taken from the page and put into it again begins anew.
  figure.addEventListener('ready', () => beginning > 0 || beginInTurn());
  model.on('change:link', beginInTurn);
  model.on('change:experiment', beginInTurn);
  model.on('change:gains', driveInTurn);
  model.on('change:_wanted', advanceInTurn);
  return () => {
    model.off('change:link', beginInTurn);
    model.off('change:experiment', beginInTurn);
    model.off('change:gains', driveInTurn);
    model.off('change:_wanted', advanceInTurn);
    clearTimeout(timer);
    el.replaceChildren();
    URL.revokeObjectURL(page);
  };
}

export default { render };
