// A finger that comes down may be about to scroll the page: before it goes sideways, or is lifted, it changes nothing. And what a pointer
// holds is moved by the page alone.
import { onCapture } from './elements.js';

/** In pixels, so far a finger moves that means nothing. */
const slop = 6;

/** Whether browsers scroll the page by it, as they do by a pen. @param {PointerEvent} event */
export const canScroll = ({ pointerType }) => pointerType === 'touch' || pointerType === 'pen';

/** @param {Element} element @param {PointerEvent} event */
export const mayScroll = (element, event) =>
  canScroll(event) && getComputedStyle(element).touchAction !== 'none';

/** @param {PointerEvent} from @param {PointerEvent} to */
export const isSideways = (from, to) =>
  Math.abs(to.clientX - from.clientX) > Math.max(slop, Math.abs(to.clientY - from.clientY));

/** Browsers move a slider as soon as a finger is on it, and leave it there when that scrolls the page. */
export function steadySliders() {
  /** What a finger holds, and had held when the page scrolled. @type {{ slider: HTMLInputElement, value: string, from: PointerEvent } | null} */
  let held = null;
  const letGo = () => {
    const { slider, value } = held ?? {};
    held = null;
    if (slider && slider.value !== value) slider.dispatchEvent(new Event('input', { bubbles: true }));
  };
  /** What it shows is what counts. */
  const putBack = () => {
    if (held) held.slider.value = held.value;
  };
  /** @param {PointerEvent} event */
  const isHolding = ({ pointerId }) => pointerId === held?.from.pointerId;
  onCapture(['pointerdown'], (event) => {
    const { target: slider } = event;
    // With another finger, or the palm beside a pen, nobody is about to press.
    putBack();
    const isSlider = slider instanceof HTMLInputElement && slider.type === 'range';
    held = isSlider && canScroll(event) ? { slider, value: slider.value, from: event } : null;
  });
  onCapture(['keydown'], () => {
    putBack();
    held = null;
  });
  onCapture(['pointermove'], (event) => {
    if (held && isHolding(event) && isSideways(held.from, event)) letGo();
  });
  onCapture(['pointerup'], (event) => isHolding(event) && letGo());
  onCapture(['pointercancel'], (event) => isHolding(event) && putBack());
  onCapture(['input', 'change'], (event) => {
    if (event.target === held?.slider) event.stopImmediatePropagation();
  });
}

/** What is moved by hand, and no copy of it. */
const held = 'input[type="range"], button, canvas, svg, [role="application"], [role="slider"]';

/** Where something is selected, browsers take it along from whatever of it is pressed, and the page hears no more of the pointer. */
export function keepHeld() {
  let isHeld = false;
  onCapture(['pointerdown'], ({ target }) => {
    isHeld = target instanceof Element && target.closest(held) !== null;
  });
  onCapture(['dragstart'], (event) => isHeld && event.preventDefault());
}
