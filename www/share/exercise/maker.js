// The panel in which a lecturer makes an exercise; the page beside it shows at once what students will see.
/** @import { Engine, PaperResult, Triple } from '../../core/engine.js' */
/** @import { Linked } from '../../link/keys.js' */
/** @import { Opened } from '../../run/actions/page.js' */
/** @import { Exercise, Group, Way } from '../../run/exercise.js' */
/** @import { Driver, State } from '../../run/state.js' */
/** @import { SheetTools } from '../load.js' */
import './maker.css';
import { html, nothing, render } from 'lit-html';
import { live } from 'lit-html/directives/live.js';
import { copy } from '../../kit/copy.js';
import { byId } from '../../kit/elements.js';
import { segmentedOf } from '../../kit/fields.js';
import { addressOf } from '../../kit/host.js';
import { watch } from '../../kit/memo.js';
import { listed } from '../../kit/segmented.js';
import { closeButton, selectAll, valueIn } from '../../kit/templates.js';
import { createTask, preset as parkPreset } from '../../parts/park/task.js';
import { inSight } from '../../parts/parts.js';
import {
  asksSomething,
  groupNames,
  isEmpty,
  noExercise,
  isHiddenWithPaper,
  mostOfTask,
  wayOf,
  withWay,
} from '../../run/exercise.js';
import { caughtUp, nothingDone } from '../../run/state.js';
import { nobody, undrawn } from '../../run/variant.js';
import { createPanel } from '../../settings/panel.js';
import { exercise as exerciseWords, lab } from '../../words/index.js';
import { frameOf, handedAddress, isOnDisk } from '../frame-text.js';
import { createAimFields } from './aim-fields.js';
import { createEasy } from './easy.js';
import { createPreview } from './preview.js';
import { createPackaging } from '../scorm/button.js';
import words from '../words/index.js';

const { texts } = words;

/** What is to be made: of the exercise that was opened, or the draft that was begun of it, which who looks away finds again. */
function createDrafts() {
  let begunOf = noExercise;
  return (/** @type {Pick<State, 'exercise' | 'maker'>} */ { exercise, maker }) => {
    const isBegun = isEmpty(exercise) || exercise === begunOf;
    begunOf = exercise;
    return isBegun ? maker.draft : exercise;
  };
}

/** @param {SheetTools} tools */
export function createMaker({ engine, store, actions, links, paper }) {
  const panel = createPanel('maker', 'settings column maker');
  let [status, linkNow, linkSaid] = ['', '', ''];
  const draftNow = () => store.get().maker.draft;
  const change = (/** @type {Partial<Exercise>} */ patch) =>
    actions.makeExercise({ draft: { ...draftNow(), ...patch } });
  const aim = createAimFields(draftNow, change, store.redraw);
  const easyOf = createEasy({ engine, paper }, store.redraw);
  const preview = createPreview(store.redraw);
  /** @param {string} text @param {string} [of] The exercise of which it is said. */
  const say = (text, of = linkNow) => {
    status = text;
    linkSaid = of;
    store.redraw();
  };
  const packaging = createPackaging(say);
  const close = () => actions.makeExercise({ open: false });
  const on = {
    close,
    /** Not of what was drawn: two may be pressed within one frame. @param {Group} group @param {Way} way */
    choose: (group, way) => change(withWay(draftNow(), group, way)),
    type: (/** @type {Event} */ event) => change({ task: valueIn(event) }),
    toLab: () => actions.openLinked(parkedInLab(engine, store.get()), []),
    copyLink: () => copy('maker-link', words.copied, words.notCopied).then(say),
    copyFrame: () => copy('maker-frame', words.textCopied, words.textNotCopied).then(say),
  };
  followEscape(panel, close);

  const draftIn = createDrafts();
  const openChanged = watch();
  // Closed as it begins, it gives no focus back.
  openChanged(false);
  const changed = watch();
  const asked = () => [aim.typed(), preview.chosen(), packaging.asks()];
  return {
    open() {
      status = '';
      const draft = draftIn(store.get());
      aim.read(draft);
      actions.makeExercise({ open: true, draft });
    },

    /** @param {State} state */
    draw(state) {
      const { open, draft } = state.maker;
      const isOther = openChanged(open);
      panel.hidden = !open;
      if (!open) {
        // The button may have been hidden until now.
        if (isOther && !state.settings.open) byId('keep-button')?.focus();
        return preview.draw(null);
      }
      const link = links.linkOf(givenOf(caughtUp(state), draft, paper), engine.experiment);
      linkNow = link;
      // What was said of another exercise is not true of this one.
      if (link !== linkSaid) status = '';
      const isRefused = asksSomething(draft) && !inSight.lab(state);
      const easy = easyOf(state, draft);
      if (changed(state.exercise, draft, link, status, ...asked(), isRefused, easy)) {
        const addresses = {
          link: handedAddress(link),
          frame: frameOf(state, link, preview.chosen() ?? undefined),
        };
        render(
          panelOf(draft, isRefused ? null : addresses, aim.typed().error !== '', status, {
            ...on,
            fields: aim.fields(draft, state, easy.length > 0 ? easyNote(easy) : nothing),
            preview: [withinOf(state.exercise), preview.choice()],
            packaging: packaging.template(link, draft),
          }),
          panel,
        );
      }
      preview.draw(addressOf(location.href, link, true));
      // In a field a tablet would open its keyboard over what is to be seen first.
      if (isOther) byId(matchMedia('(pointer: coarse)').matches ? 'maker-close' : 'maker-task').focus();
    },
  };
}

/** Then Escape is for nothing else. @param {HTMLElement} panel @param {() => void} close */
function followEscape(panel, close) {
  panel.addEventListener('keydown', (event) => {
    if (event.key !== 'Escape') return;
    event.preventDefault();
    close();
  });
}

/** What students get: as it is on screen, but drawn for nobody yet, and driven by what may be seen. @param {State} state @param {Exercise} draft @param {readonly PaperResult[]} paper @returns {Linked} */
function givenOf(state, draft, paper) {
  const { exercise, student, driver, pins, handGains } = state;
  const given = {
    ...state,
    exercise: draft,
    student: nobody,
    work: null,
    experiment: undrawn(state.experiment, exercise.vary, student) ?? state.experiment,
  };
  if (wayOf(draft, 'paper') !== 'hidden') return given;
  const isPapers = (/** @type {Triple | null} */ gains) =>
    paper.some((row) => String(row.gains) === String(gains));
  return {
    ...given,
    driver: driver.startsWith('paper-') ? 'evolved' : driver,
    pins: pins.filter(({ gains }) => !isPapers(gains)),
    handGains: driver !== 'hand' && isPapers(handGains) ? null : handGains,
  };
}

/** The task of the parking place, where it can be handed in. @param {Engine} engine @param {State} state @returns {Opened} */
const parkedInLab = (engine, { pins, exercise, student }) => ({
  ...nothingDone,
  page: 'lab',
  preset: parkPreset,
  experiment: createTask(engine).experiment(1),
  pins,
  exercise,
  student,
  parts: {},
});

/** What says why nothing is handed out. @param {boolean} isWrong */
const whyNot = (isWrong) => (isWrong ? 'maker-status maker-aim-error' : nothing);

/**
 * @param {Exercise} draft @param {{ link: string, frame: string } | null} addresses None where it could not be handed in. @param {boolean} isWrong What is typed is not what the link has. @param {string} status
 * @param {Record<'fields' | 'preview' | 'packaging', unknown> & Record<'close' | 'copyLink' | 'copyFrame' | 'toLab', () => void> & { choose: (group: Group, way: Way) => void, type: (event: Event) => void }} on
 */
const panelOf = (draft, addresses, isWrong, status, on) => html`
  <div class="settings-head">
    <h2 id="maker-title">${texts.makerTitle}</h2>
    ${closeButton('maker-close', texts.makerClose, on.close)}
  </div>
  <div class="settings-groups">
    <p class="muted">${texts.makerHelp}</p>
    ${on.preview}
    <label for="maker-task" class="maker-label">${texts.makerTask}</label>
    <textarea id="maker-task" rows="3" aria-describedby="maker-count" maxlength=${mostOfTask} .value=${live(draft.task)}
      @input=${on.type}></textarea>
    <p id="maker-count" class="muted">${words.countText(draft.task.length, mostOfTask)}</p>
    ${on.fields}
    <div id="maker-groups">${groupNames.map((group) => rowOf(draft, group, on.choose))}</div>
  </div>
  <div class="maker-foot">
    ${
      addresses
        ? html`<input id="maker-link" type="text" readonly aria-label=${texts.makerLink} .value=${addresses.link} @focus=${selectAll}>
          <button id="maker-copy-link" type="button" class="primary" .disabled=${isWrong} aria-describedby=${whyNot(isWrong)} @click=${on.copyLink}>${texts.makerCopyLink}</button>
          <input id="maker-frame" type="text" readonly aria-label=${texts.makerFrame} .value=${addresses.frame} @focus=${selectAll}>
          <button id="maker-copy-frame" type="button" .disabled=${isWrong} aria-describedby=${whyNot(isWrong)} @click=${on.copyFrame}>${texts.makerCopyFrame}</button>
          <fieldset class="around" .disabled=${isWrong} aria-describedby=${whyNot(isWrong)}>${on.packaging}</fieldset>
          ${isOnDisk() ? html`<p id="maker-disk" class="muted">${texts.makerOnDisk}</p>` : nothing}`
        : html`<p id="maker-refused" class="field-error" role="alert">${texts.makerPark}</p>
          <button id="maker-to-lab" type="button" class="primary" @click=${on.toLab}>${texts.makerToLab}</button>`
    }
    <p id="maker-status" class="muted" role="status">${isWrong && addresses ? texts.makerWrong : status}</p>
  </div>`;

/** @param {Exercise} exercise That is open. */
const withinOf = ({ locked, hidden }) =>
  locked.length + hidden.length > 0 ? html`<p id="maker-within">${texts.makerWithin}</p>` : nothing;

/** @param {readonly Driver[]} easy */
const easyNote = (easy) => {
  const names = listed(lab.drivers).flatMap(({ value, text }) => (easy.includes(value) ? [text] : []));
  return html`<p id="maker-easy" class="muted">${words.easyText(names, exerciseWords.groups.drives)}</p>`;
};

/** @param {Exercise} draft @param {Group} group @param {(group: Group, way: Way) => void} onChoose */
const rowOf = (draft, group, onChoose) => html`
  <div class="maker-row">
    <span class="maker-name" aria-hidden="true">${exerciseWords.groups[group]}</span>
    ${segmentedOf(
      `maker-${group}`,
      exerciseWords.groups[group],
      listed(words.ways).map((way) => ({
        ...way,
        disabled: isHiddenWithPaper(draft, group) && way.value !== 'hidden',
      })),
      wayOf(draft, group),
      (way) => onChoose(group, way),
    )}
    ${isHiddenWithPaper(draft, group) ? html`<p class="muted">${texts.makerPaperInLesson}</p>` : nothing}
  </div>`;
