// What the core, the workers and the browser say when something is refused or fails, in Korean.
import { grouped } from './numbers.js';

/** What the core demands, as it says it, and the same in Korean. @type {readonly (readonly [RegExp, string])[]} */
const demands = [
  [/^a whole number from (\S+) to (\d+), the newest$/, '$1 이상 $2 이하의 정수($2: 최신 세대)'],
  [/^a whole number from (\S+) to (\S+)$/, '$1 이상 $2 이하의 정수'],
  [/^a number from (\S+) to the horizon of (\S+) s$/, '$1 이상, 제한 시간 $2초 이하의 수'],
  [/^a number from (\S+) to (\S+), or null for no limit$/, '$1 이상 $2 이하의 수 또는 null(제한 없음)'],
  [
    /^a number from (\S+) to (\S+) (\S+), or null for no limit$/,
    '$1 이상 $2 $3 이하의 수 또는 null(제한 없음)',
  ],
  [/^a number from (\S+) to (\S+) (\S+)$/, '$1 이상 $2 $3 이하의 수'],
  [/^a number from (\S+) to (\S+)$/, '$1 이상 $2 이하의 수'],
  [/^a number over 0 on a log axis$/, '로그 축에서는 0보다 큰 수'],
  [/^a finite number$/, '유한한 수'],
  [/^a list of 1 to (\d+) postures$/, '자세 1~$1개의 목록'],
  [/^at most (\S+) times sampleTime$/, 'sampleTime의 $1배 이하'],
  [/^\[low, high\] with low under high$/, '[작은 값, 큰 값] 순서의 두 수'],
  [/^0 or more for a random disturbance$/, '무작위 외란에서는 0 이상의 수'],
  [/^(\S+) or more with the method (\S+)$/, '$2 방법에서는 $1 이상의 정수'],
  [
    /^at most (\S+) with (\S+) starts? and (\S+) samples a run$/,
    '출발점 $2개, 주행당 샘플 $3개에서는 최대 $1',
  ],
];

/** Whole numbers of five digits and more, in groups as elsewhere. @param {string} text */
const inGroups = (text) => text.replace(/(?<![\d.])\d{5,}(?![\d.])/g, (digits) => grouped(Number(digits)));

/** @param {string} expected */
function demanded(expected) {
  if (/^'.+' or '.+'$/.test(expected)) return `${expected.replaceAll(' or ', ', ')} 가운데 하나`;
  const found = demands.find(([pattern]) => pattern.test(expected));
  return inGroups(found ? expected.replace(...found) : expected);
}

/** @type {readonly (readonly [RegExp, (...parts: string[]) => string])[]} */
const known = [
  [
    /^(.+?) must be (.+), but was (.+)$/s,
    (_, field, expected, found) => `${field}: 허용되는 값은 ${demanded(expected)}입니다. 입력값: ${found}.`,
  ],
  [/^A worker was lost(?:: (.*))?$/s, (_, reason) => `계산을 맡은 워커가 멈추었습니다${because(reason)}`],
  [
    /^No worker can be started(?:: (.*))?\. The server [^:]*$/s,
    (_, reason) =>
      `워커를 시작할 수 없습니다${because(reason)}. 이 페이지를 보내는 서버나 이 페이지가 들어 있는 프레임이 백그라운드 계산을 금지했거나(worker-src, sandbox), 서버에 연결되지 않거나, 새 버전이 나와 그 파일이 서버에 없을 수 있습니다. 새 버전이 나왔다면 페이지를 새로 고치십시오. 주소에 화면의 내용이 담겨 있어 그대로 돌아옵니다. 워커가 필요 없는 것은 계속 쓸 수 있습니다.`,
  ],
  [/^it did not begin$/, () => '시작했다는 응답이 없음'],
  [/^an error in the core$/, () => '코어 내부 오류입니다'],
  [/^it was ended$/, () => '도중에 종료되었습니다'],
  [/^its answer cannot be read$/, () => '응답을 읽을 수 없습니다'],
];

/** @param {string} [reason] */
const because = (reason) => (reason ? `: ${said(reason)}` : '');

/** @param {string} message */
export const said = (message) =>
  known.reduce((text, [pattern, write]) => text.replace(pattern, write), message);
