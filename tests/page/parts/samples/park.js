// What tests have to know of Park.

const ofParked = 'what goes with the sliders of Park, which stay';

/** @type {import('../samples.js').Sample} */
export const sample = {
  free: ['park-again', 'park-close', 'park-next', 'park-previous'],
  controls: {
    gains: [['', '#park-kx, #park-ky, #park-ktheta']],
    run: [['', '#park-evolve']],
  },
  essentials: ['.park-plane', '#park-evolve'],
  lasting: {
    gains: ofParked,
    best: ofParked,
    bred: ofParked,
    evolving: ofParked,
    between: ofParked,
    looked: ofParked,
    seed: ofParked,
    ends: ofParked,
    endsBefore: ofParked,
  },
  readout: null,
  pictures: [
    {
      setUp: (page) =>
        page.until(
          'all have driven',
          () => document.querySelector('.park-side [role="status"]')?.textContent,
        ),
      pictures: [{ name: 'The parking place', key: 'park', texts: [], lines: 200 }],
    },
  ],
};
