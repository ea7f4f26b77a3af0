// Every word of the disturbance part.

export const texts = {
  disturbanceTitle: 'Disturbance',
};
