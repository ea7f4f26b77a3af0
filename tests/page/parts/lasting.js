// Why what a part keeps stays when a link is opened that says nothing of it.

export const computed = 'computed for what is on screen, and again for what comes';
export const found = 'what was found here, which says of what';
export const underWay = 'work that goes on';
export const asked = 'what is asked for elsewhere, of the part that a link opens';
