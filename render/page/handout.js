"use strict";
// The lesson on paper.

function handout() { // every frame as a numbered picture and its sentence, for printing
  let last = "";
  const own = live.altered.map(n => data.knobs.find(k => k.given === n)).map(k => `; ${k.plan ? "μ" : html(k.name)} = ${number(live.given[k.given])} ${k.plan ? "" : k.unit[state.lang]}`);
  $("handout").innerHTML = `<p>${$("value").textContent}${own.join("")}</p>`;
  data.frames.forEach((f, k) => {
    const key = planOf(k), onScheme = f.plan === "position", p = data.plans.find(p => p.key === f.plan);
    if (f.plan !== last && !(onScheme && f.moments !== null)) {
      $("handout").insertAdjacentHTML("beforeend", `<h2>${p.title[state.lang]}, μ = ${filled(p.mu[state.lang])}</h2>`);
      last = f.plan;
    }
    const item = document.createElement("article"), figure = svg("svg", { class: "figure" });
    item.innerHTML = `<h3>${k + 1}</h3>`;
    item.appendChild(figure);
    if (onScheme) new Scheme(figure, data, [350, 205]).draw(seenAt(k), f);
    else new Plan(figure, data, [350, 205]).show(key, seenAt(k), f);
    const begins = f.equation !== null && data.frames.findIndex(g => g.equation === f.equation) === k && !onScheme;
    const equation = begins ? lines(data.equations[f.equation], false, f, data.frames.length) : "";
    item.insertAdjacentHTML("beforeend", `${equation}<p>${sentence(f.said[state.lang], f.plan)}</p><p class="why">${sentence(f.why[state.lang], f.plan)}</p>`);
    $("handout").appendChild(item);
  });
}
