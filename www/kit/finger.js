// A finger that comes down may be about to scroll the page: before it goes sideways, or is lifted, it changes nothing. And what a pointer
// holds is moved by the page alone.
import { onCapture } from './elements.js';

/** In pixels, so far a finger moves that means nothing. */
const slop = 6;

/** @param {Element} element @param {PointerEvent} event */
export const mayScroll = (element, { pointerType }) =>
  pointerType === 'touch' && getComputedStyle(element).touchAction !== 'none';

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
  onCapture(['pointerdown'], (event) => {
    const { target: slider, pointerType } = event;
    const isSlider = slider instanceof HTMLInputElement && slider.type === 'range';
    held = isSlider && pointerType === 'touch' ? { slider, value: slider.value, from: event } : null;
  });
  onCapture(['keydown'], () => {
    held = null;
  });
  onCapture(['pointermove'], (event) => {
    if (held && isSideways(held.from, event)) letGo();
  });
  onCapture(['pointerup'], letGo);
  onCapture(['pointercancel'], () => {
    if (held) held.slider.value = held.value;
  });
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
