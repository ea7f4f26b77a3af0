// The panel in which a lecturer makes an exercise; the page beside it shows at once what students will see.
/** @import { Exercise, Group } from '../../run/exercise.js' */
/** @import { State } from '../../run/state.js' */
/** @import { SheetTools } from '../load.js' */
import './maker.css';
import { html, render } from 'lit-html';
import { live } from 'lit-html/directives/live.js';
import { copy } from '../../kit/copy.js';
import { byId, create } from '../../kit/elements.js';
import { addressOf } from '../../kit/host.js';
import { watch } from '../../kit/memo.js';
import { choicesOf } from '../../kit/segmented.js';
import { closeButton, selectAll, valueIn } from '../../kit/templates.js';
import { groupNames, isEmpty, mostOfTask, wayOf, withWay } from '../../run/exercise.js';
import { nobody, undrawn } from '../../run/variant.js';
import { exercise as exerciseWords } from '../../words/index.js';
import { frameOf } from '../frame-text.js';
import { createAimFields } from './aim-fields.js';
import { createPreview } from './preview.js';
import { createPackaging } from '../scorm/button.js';
import words from '../words/index.js';

const { texts } = words;

/** @param {SheetTools} tools */
export function createMaker({ engine, store, actions, links }) {
  const panel = create('aside', 'settings maker');
  panel.id = 'maker';
  panel.hidden = true;
  panel.setAttribute('aria-labelledby', 'maker-title');
  byId('instrument').prepend(panel);
  let status = '';
  const change = (/** @type {Exercise} */ draft) => actions.makeExercise({ draft });
  const aim = createAimFields(() => store.get().maker.draft, change, store.redraw);
  const preview = createPreview(store.redraw);
  const say = (/** @type {string} */ text) => {
    status = text;
    store.redraw();
  };
  const packaging = createPackaging(say);
  const close = () => {
    actions.makeExercise({ open: false });
    byId('keep-button').focus();
  };
  const on = {
    close,
    change,
    copyLink: () => copy('maker-link', words.copied, words.notCopied).then(say),
    copyFrame: () => copy('maker-frame', words.textCopied, words.textNotCopied).then(say),
  };
  panel.addEventListener('keydown', ({ key }) => {
    if (key === 'Escape') close();
  });

  const openChanged = watch();
  const changed = watch();
  return {
    open() {
      const { exercise, maker } = store.get();
      status = '';
      const draft = isEmpty(exercise) ? maker.draft : exercise;
      aim.read(draft);
      actions.makeExercise({ open: true, draft });
    },

    /** @param {State} state */
    draw(state) {
      const { open, draft } = state.maker;
      const isOther = openChanged(open);
      panel.hidden = !open;
      if (!open) return preview.draw(null);
      const link = links.linkOf(givenOf(state, draft), engine.experiment);
      if (changed(draft, link, status, aim.version(), preview.chosen(), packaging.asks())) {
        const addresses = {
          link: addressOf(location.href, link, false),
          frame: frameOf(state, link, preview.chosen() ?? undefined),
        };
        render(
          panelOf(draft, addresses, status, {
            ...on,
            fields: aim.fields(draft),
            preview: preview.choice(),
            packaging: packaging.template(link, draft),
          }),
          panel,
        );
      }
      preview.draw(addressOf(location.href, link, true));
      if (isOther) byId('maker-task').focus();
    },
  };
}

/** What students get: as it is on screen, but drawn for nobody yet, and driven by what may be seen. @param {State} state @param {Exercise} draft @returns {State} */
function givenOf(state, draft) {
  const { exercise, student, driver } = state;
  const isHidden = driver.startsWith('paper-') && wayOf(draft, 'paper') === 'hidden';
  return {
    ...state,
    exercise: draft,
    student: nobody,
    experiment: undrawn(state.experiment, exercise.vary, student) ?? state.experiment,
    driver: isHidden ? 'evolved' : driver,
  };
}

/**
 * @param {Exercise} draft @param {{ link: string, frame: string }} addresses @param {string} status
 * @param {{ fields: unknown, preview: unknown, packaging: unknown, close: () => void, change: (draft: Exercise) => void, copyLink: () => void, copyFrame: () => void }} on
 */
const panelOf = (draft, { link, frame }, status, on) => html`
  <div class="settings-head">
    <h2 id="maker-title">${texts.makerTitle}</h2>
    ${closeButton('maker-close', texts.makerClose, on.close)}
  </div>
  <div class="settings-groups">
    <p class="muted">${texts.makerHelp}</p>
    ${on.preview}
    <label for="maker-task" class="maker-label">${texts.makerTask}</label>
    <textarea id="maker-task" rows="3" aria-describedby="maker-count" maxlength=${mostOfTask} .value=${live(draft.task)}
      @input=${(/** @type {Event} */ event) => on.change({ ...draft, task: valueIn(event) })}></textarea>
    <p id="maker-count" class="muted">${words.countText(draft.task.length, mostOfTask)}</p>
    ${on.fields}
    <div id="maker-groups">${groupNames.map((group) => rowOf(draft, group, on.change))}</div>
  </div>
  <div class="maker-foot">
    <input id="maker-link" type="text" readonly aria-label=${texts.makerLink} .value=${link} @focus=${selectAll}>
    <button id="maker-copy-link" type="button" class="primary" @click=${on.copyLink}>${texts.makerCopyLink}</button>
    <input id="maker-frame" type="text" readonly aria-label=${texts.makerFrame} .value=${frame} @focus=${selectAll}>
    <button id="maker-copy-frame" type="button" @click=${on.copyFrame}>${texts.makerCopyFrame}</button>
    ${on.packaging}
    <p id="maker-status" class="muted" role="status">${status}</p>
  </div>`;

/** @param {Exercise} draft @param {Group} group @param {(draft: Exercise) => void} onChange */
const rowOf = (draft, group, onChange) => html`
  <div class="maker-row">
    <span class="maker-name" aria-hidden="true">${exerciseWords.groups[group]}</span>
    <fieldset id="maker-${group}" class="segmented">${choicesOf(
      `maker-${group}`,
      exerciseWords.groups[group],
      words.ways,
      wayOf(draft, group),
      (way) => onChange(withWay(draft, group, way)),
    )}</fieldset>
  </div>`;
