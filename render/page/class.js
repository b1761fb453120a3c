const heads = [...document.querySelectorAll("thead th")], choice = document.querySelector(".sort select");
/** @type {(th: any) => void} */
function sort(th) { // by its column, reversed if already sorted by it
  const down = th.ariaSort === "ascending", body = document.querySelector("tbody");
  const key = (/** @type {any} */ row) => row.children[th.cellIndex].textContent;
  const rows = [...body.rows].sort((a, b) => Number(key(a) === "") - Number(key(b) === "") ||
    key(a).localeCompare(key(b),
    document.documentElement.lang, { numeric: true }) * (down ? -1 : 1));
  for (const one of heads) one.removeAttribute("aria-sort");
  th.ariaSort = down ? "descending" : "ascending";
  choice.value = th.cellIndex;
  body.append(...rows);
}
for (const th of heads) th.firstChild.onclick = () => sort(th);
choice.onchange = () => { if (choice.value) sort(heads[choice.value]); };
