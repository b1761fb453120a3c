// The data pages get from Python and pass between modules; a page creates its elements itself and knows them.
interface ParentNode {
  querySelector(selectors: string): any;
  querySelectorAll(selectors: string): NodeListOf<any>;
}
interface Window { opener: any; planes: any; }
// a key looked up exists: Python guarantees it, or the page checks first
interface Array<T> { find(sought: (one: T, k: number) => unknown): T; pop(): T; }
interface Map<K, V> { get(key: K): V; }
interface WeakMap<K extends WeakKey, V> { get(key: K): V; }
interface URLSearchParams { get(name: string): string; }
interface Document { getElementById(id: string): HTMLElement; }
interface String { match(by: RegExp): string[]; }
declare var planes: any;

type Said = Record<string, string>; // by language; null, here as below, where there is none
type Spot = number[]; // a place: x, y
type Box = number[]; // left, low, right, high
type Numbers = Record<string, number>;
type Ends = Spot[]; // of a stroke
type There = (name: string) => Spot;
type Places = (half: number, tall: number) => number[][];
type Attributes = Record<string, string | number>;

interface Knob {
  given: string; at: number; tied: string[]; name: string; unit: Said; when?: Said; plan: string; reach: number;
  stays?: boolean; drive?: boolean;
}
interface Force { name: string; mark: string; along: string; size: string; arm: string; foot: string; }
interface Couple { name: string; link: string; size: string; sign: number; }
interface Moments { about: string; plan: string; links: string[]; forces: Force[]; couples: Couple[]; }
interface Tool { tool: string; to: string[]; from: string[]; guide?: string; }
interface Turns { vector: string; rate: string; point: string; about: string; }
interface Row {
  name: string; kind?: string; head?: string; letters: string; numbers: string; value: string; arm?: string;
  turns?: boolean; unit?: string;
}
interface Frame {
  key: string; plan: string; makes: string[]; uses: string[]; equation: number; terms: string[]; said: Said;
  why: Said; moments: number; turns: Turns; values: string[]; tools: Tool[]; rows: Row[]; tells: string[];
  chapter: string; still: Said;
}
interface Segment { plan: string; start: string; end: string; names: string[]; pen: string; sum?: boolean; }
interface Trace { lines?: string[]; arcs?: string[]; }
interface Link {
  name: string; points: string[]; slides: string; round: { centre: string; link: string };
}
interface Sign { sign: string; mark: string; shows?: string; along?: string; turn?: number; towards?: string; }
interface Guide { name: string; link: string; mark: string; }
interface Term { name: string; action: string; known: number; start?: string; end?: string; at?: string; minus?: boolean; }
interface Equation { plan: string; total: Term; closed: boolean; sides: Term[][]; }
interface PlanOf { key: string; links: string[]; mu: Said; title: Said; fixed: string[]; }
interface Offer { value: any; said: Said; why?: Said; }
interface Question {
  frame: number; kind: string; what: any; mu?: string; signed?: boolean; offered: Offer[]; marks: string[]; most: number;
  name: string; unit: Said;
}
interface Slip { m: string; at: string; names: (string | Said)[]; place: number[]; }
interface TapeData {
  names: Numbers; ops: string; consts: Record<string, number | null>; givens: Numbers; sources?: number[][];
}
interface Drive { symbol: string; given: string; at: number; held: Said; from: number; to: number; }
interface LessonData {
  title: Said; moves: boolean; formula: string; drive: Drive; home: Numbers; knobs: Knob[]; drags: Record<string, string[]>; id: string;
  plans: PlanOf[]; segments: Segment[]; traces: Record<string, Trace>; moments: Moments[]; acts: Said;
  under: Record<string, { name: string; from: number }>;
  bodies: Record<string, Moments>; reckoned: { words: Record<string, Said>; units: Record<string, Said> };
  scheme: { links: Link[]; guides: Guide[]; signs: Sign[]; pivots: string[]; driver: string; drawn: Statics }; helpers: string[]; equations: Equation[];
  frames: Frame[]; related: Record<string, string[]>; leaning?: Record<string, any>; units: Record<string, Said>;
  results: { name: string; value: string; unit: Said }[]; marks: Record<string, number[]>; values: Numbers;
  turned: Record<string, number[]>; sharp: Numbers; holds: { at: number; said: Said }[]; slips: Slip[]; lines: Said;
  judging: Numbers; practice: Question[]; mistakes: Record<string, { said: Said; parts: string[] }>; tape: TapeData;
  blunt: Record<string, Said>; centres: Record<string, string[][]>;
  noted: Record<string, Said>;
  pending?: boolean; // its practice is still to come
  number: number; titles: Said[]; paragraphs: { frame: number; view: string; knobs: string[]; said: Said }[]; // an essay's
}

interface Statics {
  strokes: { plan: string; kind: string; name: string; ends: string[] }[];
  loads: { name: string; mark: string; along: string; size: string }[];
  members: string[]; numbered: string[];
}

interface Stroke { pen: string; points: Spot[]; closed?: boolean; r?: number; } // mm; with a radius a circle
interface PaperSigns {
  signs: Record<string, Stroke[]>; heads: Record<string, number[]>; headless: number; least: number; reach: number;
  gap: number; wide: number;
}
interface Label { names: string[]; half: number; size: number; all: number[][]; key: string; of?: Ends;
  node?: SVGElement; }
interface Shown { a: Spot; b: Spot; kind: string; names: string[]; }
interface Zone { kind: string; mark: string; from: number; to: number; least: number; }
interface Looked { box: Box; runs: Record<string, number[]>; }
interface Way { a: Spot; b: Spot; n: number; u: Spot; }
interface Act {
  tool: string; show(share: number, parent: Element): void; line?(share: number, over: Element): void; [place: string]: any;
}
interface Pencil { at: Spot; a: number; r: number; mm: number; end: Spot; wrong?: boolean; }
interface Asking { asking(name: string): boolean; given(name: string): number; }
interface Mark {
  name: string; key: string; x: number; y: number; read: boolean; miss: number[]; true: Spot; free: number[]; error: number;
  from: string | null; vector: string;
}
interface Judged { verdict: string; close: boolean; own: any; free: any; }
interface Found {
  marks: Record<string, Judged>; first: string; named: any; asWell?: string; limit: number; sentence: string;
  verdict: string;
}

interface Sketch {
  title: string; points: Record<string, Spot>; fixed: string[]; loads: { link: string; point: string }[];
  guides: Record<string, { at: Spot; angle: number; link: string }>;
  links: Record<string, { points: string[]; slides: string | null; centre: string | null; heavy?: boolean }>;
  drive: { link: string; kind: string; rate: number; on?: string } | null;
  motion?: Record<string, Spot[]>; round?: boolean;
}
interface End { point: string; link: string; guide: string; at: Spot; } // of what is drawn
interface View { k: number; px(p: Spot): Spot; m(p: Spot): Spot; }
interface Shelved { name: string; title: Said; formula: string; text: string; sketch: Sketch; }
interface Help { label: string; from: string; to: string; path?: string[]; value?: string; sketch?: Sketch; act?: string; }
interface Problem { line: number; column: number; said: string; help: Help[]; doubt?: boolean; }
