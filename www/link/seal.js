// Digits by which a link that was cut or changed on its way is known. They are no secret: who wants can make them.
import { digitsOf } from '../kit/hash.js';
import { pairOf } from './values.js';

/** Of these a link is the same without. */
const beside = ['handin', 'lang', 'v'];

/** @param {string} link the text after # @param {string} more what is sealed beside it */
export function sealOf(link, more) {
  const [page, ...rest] = link.split('&');
  const pairs = rest.map(pairOf).filter(([key]) => !beside.includes(key));
  return digitsOf(JSON.stringify([page, pairs, more]));
}

/** Whether what is sealed last in a text belongs to the link. @param {string} link @param {string} sealed */
export function isSealed(link, sealed) {
  const at = sealed.lastIndexOf('~');
  return at >= 0 && sealed.slice(at + 1) === sealOf(link, sealed.slice(0, at));
}
