// The words of figures in the language of the page: figures/LANGUAGE.json, which the book writes, has the catalogues' texts by
// the English ones, some with {names} in the place of values (common/system/translation.hpp).
import { content } from "./content.js";

const language = document.documentElement.lang || "en";
const texts = language === "en" ? {} : await content(`${language}.json`).then((bytes) => JSON.parse(new TextDecoder().decode(bytes))).catch(() => ({}));

const place = /\{(\w+)\}/g;
const patterns = Object.keys(texts).filter((english) => english.search(place) >= 0).map((english) => {
  const words = english.split(/\{\w+\}/), names = Array.from(english.matchAll(place), ([, name]) => name);
  const fits = new RegExp(`^${words.map((part) => part.replace(/[.*+?^$()[\]{}|\\]/g, "\\$&")).join("([^]+?)")}$`);
  return { english, names, fits, length: words.join("").length, letters: words.join("").match(/[a-z]/gi)?.length ?? 0, words };
}).filter(({ words, letters }) => words[0] || letters >= 4).sort((a, b) => b.length - a.length);

/// The translation of a text, and of the values in its places; the text itself if it has none.
export function tr(text, inside = 5) {
  if (Object.hasOwn(texts, text)) return texts[text];
  const pattern = inside > 0 && /[a-z]{2}/i.test(text) && patterns.find(({ fits }) => fits.test(text));
  if (!pattern) return text;
  const values = pattern.fits.exec(text).slice(1);
  return texts[pattern.english].replace(place, (_, name) => tr(values[pattern.names.indexOf(name)], inside - 1));
}
