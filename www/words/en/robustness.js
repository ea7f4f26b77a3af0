// Every word of the robustness part.

export const texts = {
  robustnessTitle: 'Robustness',
};
