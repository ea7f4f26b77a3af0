// Robots with the same gains drive from 32 starts at once: who parks is seen, and counted.
import { html, render } from 'lit-html';
import { drawBay, drawCar } from '../../lab/car.js';
import { inMetres, postureAt, sampleBefore, trace } from '../../lab/track.js';
import { createLayer } from '../../kit/canvas.js';
import { create } from '../../kit/elements.js';
import { followSize } from '../../kit/size.js';
import { watch } from '../../kit/memo.js';
import { colour, pale } from '../../kit/palette.js';
import { unless } from '../../kit/templates.js';
import { lab } from '../../words/index.js';
import { createFilm } from './film.js';
import { planeAround } from '../views/plane-around.js';
import { restOf } from '../questions/settle.js';

/** @import { Size } from '../../kit/canvas.js' */
/** @import { Block, Live, Tools } from '../page.js' */
/** @import { Yard } from './yard.js' */
/** @typedef {{ label: (name: string, parked: number, starts: number) => string, parked: string, ofStarts: (starts: number) => string, mean: string, tooLong: string, again: string }} SwarmWords */
/** @typedef {{ name: string, yard: Yard } | null} Seen */

const margin = 28;
/** Half its length: 11 cm, as far as that can be seen, and no more than looks well. @param {number} scale Pixels a metre. */
const carOf = (scale) => Math.min(8.5, Math.max(4.5, 0.11 * scale));

/** @param {Tools} tools @param {SwarmWords} words @param {(live: Live) => Seen} seenIn @returns {Block} */
export function createSwarm({ store }, words, seenIn) {
  const canvas = /** @type {HTMLCanvasElement} */ (create('canvas', { role: 'img' }));
  const picture = create('div', 'swarm-picture layers', canvas);
  const head = create('div', 'swarm-head row');
  const element = create('div', { id: 'swarm', class: 'swarm' }, head, picture);
  const sizeOf = followSize(picture, () => store.redraw());
  const layer = createLayer(canvas);
  const film = createFilm(store);
  const begun = watch();
  const changed = watch();
  const again = () => {
    begun(null);
    store.redraw();
  };

  return {
    element,
    leave: film.leave,
    draw(live) {
      const seen = seenIn(live);
      if (!seen) {
        film.leave();
        begun(null);
        picture.hidden = true;
        if (changed(null)) render(html`<p class="muted">${words.tooLong}</p>`, head);
        return;
      }
      picture.hidden = false;
      const { name, yard } = seen;
      if (begun(yard)) film.begin(Math.max(...yard.runs.map(restOf)));
      const time = film.now();
      const size = sizeOf();
      if (!changed(yard, name, time, size, live.state.theme) || size.width === 0) return;
      const starts = yard.runs.length;
      const parked = yard.runs.filter(({ arrived, finalTime }) => arrived && finalTime <= time).length;
      canvas.setAttribute('aria-label', words.label(name, yard.parked, starts));
      render(
        html`<p class="swarm-name">${name}</p>
          <p class="swarm-count"><span>${words.parked}</span>
            <strong id="swarm-parked">${parked}</strong> <span>${words.ofStarts(starts)}</span></p>
          <p class="swarm-cost"><span>${words.mean}</span> <strong id="swarm-cost">${lab.costText(yard.cost)}</strong></p>
          <button type="button" class="link" @click=${unless(!film.isOver, again)} aria-disabled=${String(!film.isOver)}>${words.again}</button>`,
        head,
      );
      layer.draw(size, (context) => drawYard(context, size, yard, time));
    },
  };
}

/** @param {CanvasRenderingContext2D} context @param {Size} size @param {Yard} yard @param {number} time */
function drawYard(context, size, { experiment, runs }, time) {
  const plane = planeAround([...experiment.starts, experiment.goal], size, margin);
  const car = carOf(plane.scale);
  const isOver = (/** @type {typeof runs[number]} */ run) => time >= restOf(run);
  const [paper, error] = ['--paper', '--error'].map(colour);
  context.lineWidth = 1 / plane.scale;
  context.save();
  inMetres(context, plane);
  for (const run of runs) {
    context.strokeStyle = colour(isOver(run) && !run.arrived ? '--error' : '--muted');
    context.globalAlpha = pale;
    context.beginPath();
    trace(context, plane, run, sampleBefore(run, time));
    context.stroke();
  }
  context.restore();
  drawBay(context, plane.placeOf(experiment.goal), car + 4, colour('--ink'));
  for (const run of [...runs].sort((a, b) => Number(a.arrived) - Number(b.arrived))) {
    const missed = isOver(run) && !run.arrived;
    // Hollow, as at the parking place, so that not its colour alone tells it.
    const colours = missed
      ? { body: paper, wheel: error, nose: error, edge: error }
      : { body: colour('--ink'), wheel: colour('--muted'), nose: paper };
    drawCar(context, plane.placeOf(postureAt(run, time)), car, colours);
  }
}
