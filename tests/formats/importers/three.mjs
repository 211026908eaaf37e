// What three.js makes of glTF files: GLTFLoader, AnimationMixer and the plugin for
// KHR_animation_pointer. Reads jobs as JSON from the file that is named, writes what it
// found on standard output.
//
// A job has `file`, `times` in seconds and either `nodes` (their world matrices are wanted,
// column by column) or nothing of the kind (the camera's poses are).

import { readFileSync } from 'node:fs';
import { dirname, join } from 'node:path';

// What GLTFLoader expects of a browser, as far as scenes without pictures need it.
globalThis.self = globalThis;
globalThis.ProgressEvent ??= class extends Event {};
globalThis.createImageBitmap ??= async () => ({ width: 1, height: 1, close() {} });
URL.createObjectURL ??= () => 'blob:nothing';

const THREE = await import('three');
const { GLTFLoader } = await import('three/addons/loaders/GLTFLoader.js');
const { GLTFAnimationPointerExtension } = await import('@needle-tools/three-animation-pointer');

const warnings = [];
for (const kind of ['warn', 'error']) console[kind] = (...words) => warnings.push(words.map(String).join(' '));
console.log = console.warn;

// Pictures are not what is asked: every one is a texture of nothing.
class NoPictures {
    constructor() { this.name = 'NO_PICTURES'; }
    loadTexture() { return Promise.resolve(new THREE.Texture()); }
}

// Buffers beside the file come from there.
const manager = new THREE.LoadingManager();
class FromDisk extends THREE.Loader {
    load(url, done, _progress, failed) {
        try {
            const bytes = url.startsWith('data:')
                ? Buffer.from(url.slice(url.indexOf(',') + 1), 'base64')
                : readFileSync(decodeURIComponent(url));
            done(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength));
        } catch (error) { failed(error); }
    }
}
const matches = /\.(bin|glbin)$|^data:application\/(octet-stream|gltf-buffer)/i;
manager.addHandler(matches, new FromDisk(manager));

async function load(file) {
    const bytes = readFileSync(file);
    const loader = new GLTFLoader(manager);
    loader.register(() => new NoPictures());
    loader.register((parser) => {
        // The loader asks its own FileLoader for buffers unless told otherwise.
        parser.fileLoader = new FromDisk(manager);
        return new GLTFAnimationPointerExtension(parser);
    });
    const data = bytes.subarray(0, 4).toString() === 'glTF'
        ? bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.byteLength)
        : bytes.toString('utf8');
    return loader.parseAsync(data, join(dirname(file), '/'));
}

// glTF's rotations are unit quaternions; three.js takes files that break this at their word, and
// scales what they turn.
function unit(track) {
    if (track.createInterpolant.isInterpolantFactoryMethodGLTFCubicSpline) return;
    const { values } = track;
    for (let at = 0; at + 4 <= values.length; at += 4) {
        const length = Math.hypot(...values.subarray(at, at + 4));
        for (let part = at; part < at + 4; part++) values[part] /= length;
    }
}

// Keys at equal times apart from each other: the mixer seeks forwards and backwards alike.
function play(gltf, animation) {
    const mixer = new THREE.AnimationMixer(gltf.scene);
    const clips = animation === undefined ? gltf.animations : gltf.animations.slice(animation, animation + 1);
    for (const clip of clips) {
        clip.tracks.filter((track) => track.ValueTypeName === 'quaternion').forEach(unit);
        const action = mixer.clipAction(clip);
        action.setLoop(THREE.LoopOnce);
        action.clampWhenFinished = true;
        action.play();
    }
    return mixer;
}

function seek(mixer, time) {
    // LoopOnce stops at its end; later times are wanted as the last key has them.
    mixer.setTime(0);
    for (const action of mixer._actions) { action.paused = false; action.enabled = true; }
    mixer.setTime(time);
}

const numbers = (vector) => vector.toArray();

function poses(gltf, job) {
    const cameras = [];
    gltf.scene.traverse((object) => { if (object.isPerspectiveCamera) cameras.push(object); });
    const camera = job.camera === undefined ? cameras[0] : cameras.find((c) => (c.userData.name ?? c.name) === job.camera || c.parent?.userData.name === job.camera || c.parent?.name === job.camera);
    if (!camera) throw new Error(`no camera; cameras: ${cameras.length}`);
    const mixer = play(gltf);
    const frames = [];
    for (const time of job.times) {
        seek(mixer, time);
        gltf.scene.updateMatrixWorld(true);
        const turn = new THREE.Quaternion().setFromRotationMatrix(camera.matrixWorld);
        const axis = (x, y, z) => numbers(new THREE.Vector3(x, y, z).transformDirection(camera.matrixWorld));
        camera.aspect = job.aspect ?? 16 / 9;
        camera.updateProjectionMatrix();
        const frame = {
            position: numbers(new THREE.Vector3().setFromMatrixPosition(camera.matrixWorld)),
            view: axis(0, 0, -1),
            up: axis(0, 1, 0),
            fov: 2 * Math.atan(1 / camera.projectionMatrix.elements[5]) * 180 / Math.PI,
        };
        if (job.points) {
            frame.pixels = job.points.map((point) => {
                const seen = new THREE.Vector3(...point).project(camera);
                return [(seen.x + 1) / 2 * job.width, (1 - seen.y) / 2 * job.height];
            });
        }
        frames.push(frame);
    }
    return { frames, duration: Math.max(0, ...gltf.animations.map((clip) => clip.duration)) };
}

async function matrices(gltf, job) {
    const mixer = play(gltf, job.animation);
    const found = [];
    for (let index = 0; index < gltf.parser.json.nodes.length; index++) {
        found.push(await gltf.parser.getDependency('node', index));
    }
    const frames = job.times.map((time) => {
        seek(mixer, time);
        gltf.scene.updateMatrixWorld(true);
        return found.map((node) => numbers(node.matrixWorld));
    });
    return { frames, duration: Math.max(0, ...gltf.animations.map((clip) => clip.duration)) };
}

const results = [];
for (const job of JSON.parse(readFileSync(process.argv[2], 'utf8'))) {
    warnings.length = 0;
    try {
        const gltf = await load(job.file);
        const result = job.matrices ? await matrices(gltf, job) : poses(gltf, job);
        results.push({ ...result, warnings: [...new Set(warnings)] });
    } catch (error) {
        results.push({ error: error.stack ?? String(error), warnings: [...new Set(warnings)] });
    }
}
process.stdout.write(JSON.stringify(results));
