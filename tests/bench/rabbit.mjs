// The same tasks done by npm's rabbit-ear, for the benchmark to compare with.
//
//     node rabbit.mjs MODULES TASK FILE.fold SECONDS
//
// TASK is `layers` (all orders of the layers of the pattern), `fold` (one more flat fold across it,
// which numbers faces by layers) or `fold-orders` (the same, then the orders of faces that lie on
// each other, which is what a fold of katagami brings). Prints how long it took, without reading
// the file, as JSON; `over` when it was stopped after SECONDS.
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { resolve } from "node:path";
import { isMainThread, parentPort, Worker, workerData } from "node:worker_threads";

const work = ([modules, task, file]) => {
  const ear = createRequire(resolve(modules, "x.js"))("rabbit-ear");
  const text = JSON.parse(readFileSync(file, "utf8"));
  const graph = Object.fromEntries(
    Object.entries(text).filter(([key]) => /^(vertices|edges|faces)_/.test(key)));
  graph.vertices_coords = graph.vertices_coords.map((p) => p.slice(0, 2));
  const start = performance.now();
  if (task !== "layers") {
    ear.graph.flatFold(graph, [1, 0.3], [50, 50]);
  }
  if (task !== "fold") {
    ear.graph.populate(graph);
    graph.vertices_coords = ear.graph.makeVerticesCoordsFolded(graph, 0);
    ear.layer.solver(graph, 1e-6);
  }
  return (performance.now() - start) / 1000;
};

if (isMainThread) {
  const limit = Number(process.argv[5]);
  const finish = (result) => {
    console.log(JSON.stringify(result));
    process.exit(0);
  };
  const worker = new Worker(new URL(import.meta.url), { argv: [], workerData: process.argv.slice(2), stdout: true });
  worker.on("message", (seconds) => finish({ seconds, over: false }));
  worker.on("error", (error) => {
    console.error(error.message);
    process.exit(1);
  });
  setTimeout(() => finish({ seconds: limit, over: true }), 1000 * limit);
} else {
  parentPort.postMessage(work(workerData));
}
