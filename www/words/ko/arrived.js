// How many robots arrived, behind the words that count them.

/** @param {number} arrived @param {number} count */
export function arrivedText(arrived, count) {
  if (count === 1) return arrived === 1 ? '도착' : '미도착';
  if (arrived === 0) return '모두 미도착';
  return arrived === count ? '모두 도착' : `그중 ${arrived}대 도착`;
}
