// Every word of the controller as code; in Korean.
export * from './common.js';

export const texts = {
  codeHelp:
    '화면에 있는 주행의 제어기를 로봇, 시뮬레이터, 과제에 가져갑니다. 함수 하나와, 그 함수로 주차한 뒤 자신의 수치를 페이지의 수치와 나란히 출력하는 main으로 되어 있습니다.',
  codeCopy: '복사',
  codeSave: '파일로 저장',
};

export const languageLegend = '프로그래밍 언어';
export const computing = '주행을 계산하고 있습니다…';
export const copied = '코드를 복사했습니다.';
export const notCopied =
  '이 브라우저는 페이지의 복사를 허용하지 않습니다. 코드를 선택해 두었으니 키보드로 복사하십시오.';

/** @param {string} file */
export const codeLabel = (file) => `${file} 파일의 코드`;

/** What stands in the code. */
export const comments = {
  head: {
    'shim-kim': 'Kim과 Shim(1995)의 자세 제어기와 한 주행의 이득입니다.',
    kanayama: 'Kanayama 등(1990)의 제어 규칙과 한 주행의 이득입니다.',
  },
  origin: (/** @type {string} */ version) => `ep-locomotion ${version}에서 만들었습니다:`,
  page: (/** @type {number} */ cost, /** @type {string} */ end) =>
    `페이지에서는 J = ${cost}이고, 로봇은 ${end}.`,
  undisturbed: (/** @type {number} */ cost, /** @type {string} */ end) =>
    `페이지가 더하는 외란이 없으면 J = ${cost}이고, 로봇은 ${end}.`,
  ends: {
    arrived: (/** @type {number} */ time) => `${time} s 만에 주차합니다`,
    horizon: (/** @type {number} */ _time, /** @type {number} */ horizon) =>
      `${horizon} s 안에 주차하지 못합니다`,
    diverged: () => '유한한 수의 범위를 벗어납니다',
    tracking: (/** @type {number} */ _time, /** @type {number} */ horizon) =>
      `움직이는 목표를 ${horizon} s 동안 따라갑니다`,
  },
  disturbed: '이 프로그램에도 외란이 없으며, 여기 있는 수치는 모두 외란이 없을 때의 값입니다.',
  unsteady:
    '이 주행은 수의 마지막 자리에 좌우됩니다. 출발점을 백만분의 1 마이크로미터만 옮겨도 결과가 달라집니다. 따라서 언어나 프로세서가 다르면 페이지와 다른 수치가 나올 수 있습니다.',
  run: (/** @type {string} */ command) => `실행: ${command}`,

  gains: {
    'shim-kim': 'kx (1/s), ky (1/(m² s)), kθ (rad/s); 길이는 m로만: ω에는 1/m²가 숨어 있음',
    kanayama: 'kx (1/s), ky (rad/m²), kθ (rad/m)',
  },
  referenceVelocity: '목표의 속도: m/s, rad/s',
  sampleTime: '명령 사이의 시간(s)',
  largestVelocity: '속도 제한: m/s, rad/s',
  largestChange: '가속도 제한: m/s², rad/s²',
  smallest: '이보다 작은 수로 나누지 않음',
  start: 'x (m), y (m), θ (rad); 정지 상태',
  goal: 'x (m), y (m), θ (rad)',
  horizon: 's; 이때까지 달림',
  samples: '그때까지의 명령 수',
  driveTitle: '페이지의 주행',
  mainOfModule: '불러올 때가 아니라 프로그램으로 실행할 때',
  tolerance: 'm, rad: 이만큼 가까우면 주차한 것',
  slow: 'm/s, rad/s: 이보다 빠르지 않을 때',
  finalWeights: 'W, 마지막 오차의 가중치',
  velocityWeights: 'R, 속도의 가중치',
  penalty: 'κ, 음수인 이득에 대한 벌점',
  pageNumbers: '페이지의 수치: t_f, J, 마지막 자세',
  float: 'double이 없는 프로세서에서는 float: cc -DREAL=float',

  command:
    '다음 명령까지 로봇이 낼 속도 (v, w)를 m/s와 rad/s로 돌려줍니다. 로봇의 자세 (x, y, theta), 목표, 그리고 지금까지의 속도를 받습니다. 정지 상태이면 (0, 0)입니다.',
  ros: 'ROS 2에서 v는 geometry_msgs/msg/Twist의 linear.x, w는 angular.z이고 나머지는 모두 0입니다. DT초마다 하나씩 보내십시오. 자세는 목표와 같은 좌표계에서 본 odometry 또는 tf의 x, y, yaw입니다.',
  wheels:
    '반지름이 r이고 간격이 b인 두 바퀴는 오른쪽이 (v + w b / 2) / r, 왼쪽이 (v - w b / 2) / r로 돕니다. 단위는 rad/s입니다.',
  law: { 'shim-kim': '제어 법칙 (5)', kanayama: 'Kanayama의 규칙' },
  limits: '모터가 낼 수 있는 만큼만: 먼저 속도, 다음으로 그 변화',
  error: {
    'shim-kim': '오차 자세 (3): 로봇에서 목표까지, 목표의 좌표축을 따라 잽니다.',
    kanayama: '로봇에서 목표까지, 로봇의 좌표축을 따라 잽니다.',
  },
  wrap: '(-pi, pi] 안의 같은 각입니다.',
  inverse: '1 / s입니다. |s|가 정해 둔 가장 작은 수보다 작으면 그 수로 나눕니다.',
  advance: '한 샘플 뒤의 자세: 정확한 원호 (2)를 따라갑니다.',
  drive: '페이지와 똑같이 달리고, t_f와 비용 J (9), 마지막 자세를 돌려줍니다.',
  goalMoves: '목표도 움직임',
  diverged: '유한한 수의 범위를 벗어남',
  clamp: 'low와 high 사이로 제한한 값입니다. NaN은 NaN으로 둡니다.',
  handle: '제어기만 쓰려면:',
};
