// The two figures of the lesson's page: the scheme, and a plan beside it.
import { $ } from "./dom.js";
import { data } from "./page.js";
import { Plan } from "./plan.js";
import { Scheme } from "./scheme.js";

export const scheme = new Scheme($("scheme"), data), plan = new Plan($("plan"), data);
