// Checks FOLD files, every frame, by npm's fold and rabbit-ear.
//
//     node check_fold.mjs MODULES FILE.fold...
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { resolve } from "node:path";

const require = createRequire(resolve(process.argv[2], "x.js"));
const fold = require("fold");
const ear = require("rabbit-ear");
let wrong = 0;

const fail = (where, what) => {
  console.error(`${where}: ${what}`);
  wrong += 1;
};

// A frame with what it inherits.
const frame = (file, index) => {
  const { file_frames: frames = [], ...first } = file;
  const own = index === 0 ? first : frames[index - 1];
  return own.frame_inherit ? { ...frame(file, own.frame_parent), ...own } : own;
};

const copy = (graph) => JSON.parse(JSON.stringify(graph));

const checkTopology = (graph, where) => {
  const report = ear.graph.validate(copy(graph));
  if (report.summary !== "valid") fail(where, `rabbit-ear: ${JSON.stringify(report)}`);
  const changed = copy(graph);
  fold.filter.removeLoopEdges(changed);
  fold.filter.removeDuplicateEdges_vertices(changed);
  if (changed.edges_vertices.length !== graph.edges_vertices.length)
    fail(where, "fold: loops or duplicates among the edges");
  const complete = copy(graph);
  fold.convert.faces_vertices_to_faces_edges(complete);
  if (complete.faces_edges.some((edges) => edges.some((edge) => !(edge >= 0))))
    fail(where, "fold: a face with an edge that is not there");
  for (const field of ["edges_assignment", "edges_foldAngle"])
    if (graph[field].length !== graph.edges_vertices.length) fail(where, `${field}: wrong length`);
  const kinds = { M: (a) => a < 0, V: (a) => a > 0, F: (a) => a === 0, B: (a) => a === null || a === 0 };
  graph.edges_assignment.forEach((letter, edge) => {
    const fits = kinds[letter];
    if (!fits || !fits(graph.edges_foldAngle[edge]))
      fail(where, `edge ${edge}: ${letter} by ${graph.edges_foldAngle[edge]} degrees`);
  });
};

// The crease pattern: no edges cross, no vertices lie on each other.
const checkPattern = (graph, where) => {
  const changed = copy(graph);
  fold.filter.collapseNearbyVertices(changed, 1e-9);
  if (changed.vertices_coords.length !== graph.vertices_coords.length)
    fail(where, "fold: vertices on each other");
  fold.filter.subdivideCrossingEdges_vertices(changed, 1e-9);
  if (changed.edges_vertices.length !== graph.edges_vertices.length)
    fail(where, "fold: edges that cross");
};

const checkOrders = (graph, where) => {
  const count = graph.faces_vertices.length;
  const seen = new Set();
  for (const [a, b, side] of graph.faceOrders) {
    const key = a < b ? `${a} ${b}` : `${b} ${a}`;
    if (!(a >= 0 && b >= 0 && a < count && b < count && a !== b) || Math.abs(side) !== 1)
      fail(where, `faceOrders: [${a}, ${b}, ${side}]`);
    if (seen.has(key)) fail(where, `faceOrders: faces ${key} twice`);
    seen.add(key);
  }
};

for (const name of process.argv.slice(3)) {
  const file = JSON.parse(readFileSync(name, "utf8"));
  const frames = 1 + (file.file_frames ?? []).length;
  for (let index = 0; index < frames; index += 1) {
    const graph = frame(file, index);
    const where = `${name}, frame ${index}`;
    checkTopology(graph, where);
    if (graph.frame_classes.includes("creasePattern")) checkPattern(graph, where);
    if (graph.faceOrders) checkOrders(graph, where);
  }
}
process.exit(wrong > 0 ? 1 : 0);
