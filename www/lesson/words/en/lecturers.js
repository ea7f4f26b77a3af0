// The step “lecturers” in English.

export const lecturers = {
  texts: {
    begin: `Everything on this page is in its link: what you have set up opens on any machine as you left it, with the same numbers to the last digit. *Share* gives the link, the pictures and the tables. *Settings* holds every number of the experiment. Keys: press *?*.

*Share* also makes an exercise: a link with a task in your words, in which you lock or hide what your students should leave alone. Nothing in it is secret: they can always open the whole page. What they hand in is checked under *Share* as well, a whole class at once. An exercise can also be a package for Moodle (SCORM). Any part of the page and any step of the lesson can be a frame in a page of yours.`,
    cite: `*How to cite.* The method: J.-H. Kim and H.-S. Shim, “Evolutionary Programming-Based Optimal Robust Locomotion Control of Autonomous Mobile Robots”, Proceedings of the Fourth Annual Conference on Evolutionary Programming, MIT Press, 1995. This program: ep-locomotion, version {=version}; its CITATION.cff holds the entry. What the paper leaves open and we chose stands in [the step on the paper’s numbers](lesson&step=paper).`,
  },
  show: 'set it up',
  showApart: 'in its own window',
  print: 'Print this sheet',
  /** @param {string} title */
  answersTo: (title) => `${title}: what is to be seen`,
  sheets: {
    demonstration: {
      title: 'Ten minutes, for a lecture',
      apart:
        '“In its own window” shows an item without these notes, every time in the same second window: drag that one to the projector, and enlarge it there with Ctrl and +.',
      items: {
        park: {
          text: '*0 min.* Ask: who can park it? Let somebody call out numbers for the three sliders.',
          seen: 'The robot stops beside the goal. The best of the class is the mark to beat.',
        },
        random: {
          text: '*2 min.* Twenty robots with random numbers. Ask: how many will arrive?',
          seen: 'Most of them do; the best is better than the paper’s arbitrary gains.',
        },
        run: {
          text: '*3 min.* Press Reset and Run, and watch J fall; or set up generation 50.',
          seen: 'By generation 50 the best J is below that of the paper’s EP gains.',
        },
        open: {
          text: '*4 min.* How? One generation, opened: who met whom, who won, who stays.',
          seen: 'Every robot meets ten others, drawn at random. Wins decide, not J alone.',
        },
        steps: {
          text: '*5 min.* The step sizes σ. Ask: what will they do when nothing gets better any more?',
          seen: 'With this seed they shrink by many powers of ten: evolution stands still, whether or not it is at the best place.',
        },
        landscape: {
          text: '*6 min.* The ground it searched: each point is a robot. Drag the goal and watch the valley.',
          seen: 'The population sits in the dark valley.',
        },
        elsewhere: {
          text: '*7 min.* Ask: from how many other starts does this champion arrive? Press a hatched place.',
          seen: 'From far fewer than all. It learned one start, not the task.',
        },
        training: {
          text: '*8 min.* Evolve on many starts: press “Evolve all three”.',
          seen: 'With this seed, gains evolved on many starts arrive more often from starts never seen than those evolved on one. *15 seeds* shows how much of it is luck.',
        },
        close: {
          text: '*9 min.* And when the ground pushes? Theorem 2 says where {V} must still fall; how near the robot then comes, and when, it does not say.',
          seen: 'An optimiser goes by the cost, and by nothing else.',
        },
      },
    },
    plan: {
      title: 'Ninety minutes, for a class',
      note: 'Students have the page before them. They answer each question before the page shows what happens.',
      items: {
        play: {
          text: '*0 to 10 min.* Play: three numbers, one robot. Whose J is the lowest? Write each J on the board.',
          seen: 'Within minutes somebody is below the evolved gains of the paper: from one start it is easy.',
        },
        model: {
          text: '*10 to 25 min.* Steps 2 and 3: three errors, two velocities, a gain for each error. Kinematics and the error posture on the board.',
          seen: 'With {ky} = 0 the robot stops beside the goal from most places, and arrives from the paper’s start.',
        },
        theory: {
          text: '*25 to 37 min.* Step 4: let a student do the chain rule; strike the terms out, press by press.',
          seen: 'Two pairs cancel, three terms are left.',
        },
        limits: {
          text: '*37 to 45 min.* Step 5: what the proof assumes. Saturation, samples, chattering.',
          seen: '{V} rises in most drives with the limits on: the proof promises nothing about saturated wheels.',
        },
        cost: {
          text: '*45 to 52 min.* Step 6: what is good? Vote on the two questions first.',
          seen: 'With heavy weights staying at home wins.',
        },
        evolution: {
          text: '*52 to 65 min.* Steps 7 and 8: one generation, phase by phase; the step sizes and their collapse.',
          seen: 'A better robot falls, a worse one stays; the best never gets worse.',
        },
        contest: {
          text: '*65 to 73 min.* Step 9: pairs against evolution, each with a seed of their own. Collect the scores.',
          seen: 'By hand one comes to a mean J of about 13 and parks 26 of 32. Evolution comes below 13 with about seven seeds of eight, at a {ky} that nobody tried.',
        },
        task: {
          text: '*73 to 86 min.* Step 12: one start, many starts, another price. Predict each before it is shown.',
          seen: 'About a fifth, half, nearly all of the starts that no evolution saw.',
        },
        end: {
          text: '*86 to 90 min.* The seven sentences; the open task is the homework.',
          seen: 'An optimiser goes by the cost.',
        },
      },
    },
    lab: {
      title: 'Fifty minutes, for a lab',
      note: 'Students work in pairs, write down a prediction before each “set it up”, and pin what they compare.',
      items: {
        beside: {
          text: 'The robot stands beside the goal and points the right way; {ky} is 0. Predict what it does. Then find a {ky} that moves it.',
          seen: 'It does not move at all: with {ye} as the only error, only {ky} could ask for anything.',
        },
        works: {
          text: 'Driving fast counts four times as much (R of v is 4). Which gains does evolution find now, compared with before?',
          seen: 'Smaller {kx} and {kt}: the robot drives more slowly and arrives later.',
        },
        seeds: {
          text: 'Evolve 100 generations with seeds 1 to 5. How much do J and the gains differ?',
          seen: 'J agrees within one percent, {kx} and {kt} differ by more than a tenth: the valley is flat. {ky} is near 0 each time.',
        },
        population: {
          text: 'Six robots instead of twenty: how many drives until J is below 7.8? Then a hundred.',
          seen: 'With this seed the small population needs fewer drives. One seed proves nothing: run [the contest](luck&luck=contest&contestants=n-6,n-100&seeds=51&budget=4000&target=7.8). There 51 runs cannot tell six from twenty; a hundred need twice as many drives.',
        },
        kanayama: {
          text: 'Kanayama’s rule instead of the paper’s law. Let it evolve. Why does nobody arrive?',
          seen: 'With a goal at rest it never turns (ω = 0). No gains can change that.',
        },
        acceleration: {
          text: 'Gains 10, 10, 10 with limited acceleration. Explain the swings of θ from the curves of v and ω.',
          seen: 'The wheels answer late; the robot overshoots again and again and arrives much later.',
        },
        unseen: {
          text: 'How often do gains arrive from 1000 starts they have never seen: evolved on one start, on a circle, on a grid, the paper’s, the arbitrary ones? Explain the order.',
          seen: 'With this seed those evolved on one start and the paper’s EP gains are the worst: that start never asked for {ky}. One seed proves nothing: press *15 seeds*. The circle is better than the one start with each of them; the grid is not: with seed 7 it is the worst of all.',
        },
      },
    },
    exam: {
      title: 'Questions for an exam',
      items: {
        negative: {
          text: 'In {Vdot} = −{kx} {xe}² cos² {te} − {ky} {ye}⁴ − {kt} sin² {te}, let {ky} be below zero. Which errors can then grow?',
          seen: 'The second part becomes positive: {V} grows wherever it outweighs the other two, however small {ye} is, once {xe} and {te} have faded. So {ye} can grow, and the robot ends far to the side. Both theorems need all three gains above zero.',
        },
        best: {
          text: 'Why can the best J of the page’s EP never rise from one generation to the next?',
          seen: 'A robot wins every bout in which it is at least as good as its opponent. The best wins all ten, and ties go to the lower J. So it survives.',
        },
        old: {
          text: 'The offspring’s gains are drawn with the parent’s old σ, its own σ is new. When is the new σ tested?',
          seen: 'Only through its offspring, one generation later: a good σ is kept because it comes along with good gains.',
        },
        collapse: {
          text: 'With seed 1, σ has fallen by more than seven powers of ten after 300 generations. What does that say about the gains found, and what would you change?',
          seen: 'Not that they are the best: short steps survive because they spoil little, wherever the search stands. A lower bound for σ, a restart or a larger population keeps the search alive.',
        },
        ky: {
          text: 'Evolution sends {ky} to zero. Is the robot better without this term?',
          seen: 'From the one start that was driven, yes. From other starts it then stops beside the goal. The cost never asked for them.',
        },
        compare: {
          text: 'Method A ends at J 7.71, method B at 7.92, one run each. What do you have to know before you prefer A?',
          seen: 'The number of drives of each, the seeds, the spread over many seeds, and whether J counts what you want.',
        },
      },
    },
  },
};
