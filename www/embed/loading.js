// The first that a figure says to the element that holds it: that it is one, and on its way, however slow the network is.
import { isHeldByElement } from '../kit/host.js';
import { version } from './frame.js';

export function sayLoading() {
  if (isHeldByElement && parent !== window) parent.postMessage({ ep: version, type: 'loading' }, '*');
}
