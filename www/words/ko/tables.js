// Every word of the tables that stand beside pictures, in Korean.

export const texts = {
  tableButton: '표',
  tableBefore: '이전 행',
  tableAfter: '다음 행',
  tableCsv: 'CSV 내려받기',
};

/** @param {number} from @param {number} to @param {number} count */
export const rowsText = (from, to, count) => `전체 ${count}행 중 ${from}~${to}행`;

/** @param {number} newest */
export const fitnessCaption = (newest) => `적합도 곡선, 0세대부터 ${newest}세대까지`;

export const fitnessColumns = [
  '세대',
  '주행 수',
  '최소 J',
  'J 중앙값',
  '최대 J',
  '평균 σx',
  '평균 σy',
  '평균 σθ',
];

/** @param {string} across @param {string} up @param {string} third @param {number} value */
export const landscapeCaption = (across, up, third, value) =>
  `지형의 몇 지점에서 구한 J: 열은 ${across}, 행은 ${up}, 모든 지점에서 ${third} = ${value}`;

/** @param {number} headings */
export const robustnessCaption = (headings) =>
  `지도의 몇 곳에서 방향각 ${headings}개 중 도착하는 수: 열은 x(m), 행은 y(m)`;

/** @param {string} up @param {string} across */
export const corner = (up, across) => `${up} ↓, ${across} →`;
