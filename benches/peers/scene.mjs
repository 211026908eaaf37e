// three.js on the nodes of ../scene.c: AnimationMixer, then updateMatrixWorld.
//
//     node scene.mjs THREE_MODULE NODES KEYS

import process from "node:process";

const THREE = await import(process.argv[2]);
const [NODES, KEYS] = process.argv.slice(3).map(Number), RUNS = 7;
const FRAMES = Math.max(4, 200000 / NODES);

const nodes = [], tracks = [];
const times = Array.from({ length: KEYS }, (_, k) => 1 + 100 / (KEYS - 1) * k);
for (let i = 0; i < NODES; i++) {
    const node = new THREE.Object3D();
    node.name = `n${i}`;
    nodes.push(node);
    if (i > 0) nodes[Math.floor((i - 1) / 4)].add(node);
    const place = [], turn = [], scale = [];
    const axis = new THREE.Vector3(1, Math.sin(i), Math.cos(i)).normalize();
    for (let k = 0; k < KEYS; k++) {
        place.push(0.5 * Math.sin(0.37 * i + 0.9 * k), 0.5 * Math.cos(0.23 * i + 0.5 * k),
            0.5 * Math.sin(0.11 * i + 0.7 * k));
        const q = new THREE.Quaternion().setFromAxisAngle(axis, 0.6 * Math.sin(0.3 * i + k));
        turn.push(q.x, q.y, q.z, q.w);
        scale.push(1 + 0.1 * Math.sin(i + k), 1 + 0.1 * Math.cos(i + k), 1);
    }
    tracks.push(new THREE.VectorKeyframeTrack(`n${i}.position`, times, place));
    tracks.push(new THREE.QuaternionKeyframeTrack(`n${i}.quaternion`, times, turn));
    tracks.push(new THREE.VectorKeyframeTrack(`n${i}.scale`, times, scale));
}
const root = nodes[0];
// Preparing looks each name up in the whole tree; that is not counted, but would take hours.
const byName = new Map(nodes.map((node) => [node.name, node]));
THREE.PropertyBinding.findNode = (_, name) => byName.get(name);
const mixer = new THREE.AnimationMixer(root);
mixer.clipAction(new THREE.AnimationClip("all", 101, tracks)).play();

let best = Infinity;
for (let run = 0; run <= RUNS; run++) {
    const begin = process.cpuUsage();
    for (let n = 0; n < FRAMES; n++) {
        mixer.setTime(1 + (0.37 * n) % 100);
        root.updateMatrixWorld();
    }
    const { user, system } = process.cpuUsage(begin);
    const took = (user + system) / FRAMES / 1e6;
    if (run > 0) best = Math.min(best, took);
}
let sum = 0;
for (const node of nodes) {
    const m = node.matrixWorld.elements;
    sum += m[12] + 2 * m[13] + 3 * m[14];
}
console.log(JSON.stringify({ name: `three.js r${THREE.REVISION}`, nodes_per_second: NODES / best, places: sum }));
