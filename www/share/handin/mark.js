/** With this the text of a receipt begins, in every language. */
export const mark = 'ep-locomotion hand-in';
