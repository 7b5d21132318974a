// A link to the page in another language leads to the part that is read: anchors are the same in all.
addEventListener("click", (event) => {
  const link = event.target.closest("a[hreflang]");
  if (!link) return;
  const headings = Array.from(document.querySelectorAll("article :is(h2, h3, h4)[id]"));
  const read = headings.filter((heading) => heading.checkVisibility() && heading.getBoundingClientRect().top < 150);
  link.hash = read.length ? read[read.length - 1].id : "";
}, true);
