// What is said of the lesson before it is loaded.

export const texts = { lesson: 'Lesson' };

export const nav = 'Lesson';
export const tagline = 'Predict, try, see, explain: the method step by step, with the lab’s own views.';
/** Of its steps, in their order. */
export const titles = {
  drive: 'Drive it yourself',
  error: 'Where is the goal?',
  law: 'The law, term by term',
  stability: 'Why it gets there',
  limits: 'What the wheels cannot do',
  cost: 'What is a good drive?',
  generation: 'One generation by hand',
  sigma: 'A step size that adapts itself',
  duel: 'You against evolution',
  landscape: 'The landscape it searched',
  contest: 'Which part does the work?',
  task: 'Did it learn the task?',
  disturbance: 'When the ground pushes',
  paper: 'The paper’s numbers and ours',
  build: 'Build it yourself',
  lecturers: 'For lecturers',
};
