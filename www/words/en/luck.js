// Every word of the luck part.

export const texts = {
  luckTitle: 'Luck',
};
