// The addresses of the student's own functions, and of the times of their files. A host of pages has none; ./course book serves
// another file in place of this one.
export const mine = null;
export const files = null;
