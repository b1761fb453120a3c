// Reports the progress of the practice to a platform (SCORM 1.2): its score in per cent, and the end of the lesson.
import { on } from "./dom.js";
import { data } from "./page.js";
import { practice } from "./practice.js";
(() => {
  const found = (/** @type {any} */ from) => {
    for (let at = from, k = 0; at && k < 10; k++, at = at.parent === at ? null : at.parent) if (at.API) return at.API;
    return null;
  };
  let api = null;
  try { api = found(window) || (window.opener && found(window.opener)); } catch { api = null; }
  if (!api) return;
  const begun = Date.now();
  api.LMSInitialize("");
  const status = "cmi.core.lesson_status";
  if (api.LMSGetValue(status) === "not attempted") api.LMSSetValue(status, "incomplete");
  const tell = () => {
    const all = data.practice.length;
    const score = all ? Math.round(100 * Math.min(1, practice.good / Math.max(practice.asked, 1))) : 100;
    api.LMSSetValue("cmi.core.score.min", "0");
    api.LMSSetValue("cmi.core.score.max", "100");
    if (practice.asked) api.LMSSetValue("cmi.core.score.raw", String(score));
    if (practice.over) api.LMSSetValue(status, score >= 60 ? "passed" : "failed");
    api.LMSCommit("");
  };
  practice.after = tell;
  on(window, "pagehide", () => {
    const s = Math.floor((Date.now() - begun) / 1000), two = (/** @type {number} */ n) => String(n).padStart(2, "0");
    tell();
    api.LMSSetValue("cmi.core.session_time",
      `${two(Math.floor(s / 3600))}:${two(Math.floor(s / 60) % 60)}:${two(s % 60)}`);
    api.LMSFinish("");
  });
})();
