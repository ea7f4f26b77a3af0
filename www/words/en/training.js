// Every word of the training part.

export const texts = {
  trainingTitle: 'Training',
};
