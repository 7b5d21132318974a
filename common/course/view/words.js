"use strict";
// The page in the reader's language: `words`, which the server sends, has its sentences by the English ones.
const tr = (english, values = {}) =>
  (words[english] ?? english).replace(/\{(\w+)\}/g, (place, name) => values[name] ?? place);

document.documentElement.lang = language;
for (const element of document.querySelectorAll("body *")) {
  for (const name of ["aria-label", "title"])
    if (element.hasAttribute(name)) element.setAttribute(name, tr(element.getAttribute(name)));
  for (const text of element.childNodes)
    if (text.nodeType === Node.TEXT_NODE)
      text.data = text.data.replace(/\S(.*\S)?/s, (all) => tr(all.replace(/\s+/g, " ")));
}
