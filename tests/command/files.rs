//! What the command does to the files of others and its own: inputs are not overwritten, nothing is
//! left behind, a file names only what lies beside it.

use std::os::unix::fs::{PermissionsExt, chown, symlink};
use std::os::unix::process::CommandExt;
use std::path::PathBuf;
use std::time::{Duration, Instant};

use super::*;

const MESH: &str = "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 2 3\nf 1 2 4\nf 2 3 4\nf 1 3 4\n";

struct Folder(tempfile::TempDir);

impl Folder {
    fn new() -> Self {
        Self(tempfile::tempdir().unwrap())
    }

    fn at(&self, name: &str) -> PathBuf {
        self.0.path().join(name)
    }

    fn name(&self, name: &str) -> String {
        self.at(name).to_str().unwrap().to_owned()
    }

    fn put(&self, name: &str, content: impl AsRef<[u8]>) -> String {
        fs::write(self.at(name), content).unwrap();
        self.name(name)
    }

    fn names(&self) -> BTreeSet<String> {
        let entries = fs::read_dir(self.0.path()).unwrap();
        let names = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap());
        names.collect()
    }
}

fn path_with(object: &str) -> String {
    let points = "[[point]]\nposition = [3, 0, 0]\n[[point]]\nposition = [3, 3, 0]\n";
    format!("version = 1\nspace = {{ half_size = 9.0 }}\n{points}[object]\nfile = \"{object}\"\n")
}

/// Runs it in place of what would overwrite a file that was read: refused, and the file is as before.
fn refuses(arguments: &[&str], input: &str) {
    let before = fs::read(input).unwrap();
    let complaint = complaint(&run(arguments), 2);
    let last = complaint.lines().last().unwrap();
    assert!(
        last.contains("this would overwrite "),
        "{arguments:?}: {complaint}"
    );
    assert!(fs::read(input).unwrap() == before, "{arguments:?}");
}

#[test]
fn no_input_is_overwritten() {
    let folder = Folder::new();
    let mesh = folder.put("m.obj", MESH);
    let path = folder.put("p.vid", path_with("m.obj"));
    let poses = folder.name("poses.txt");
    said(&run(&["sample", PYRAMID, "-o", &poses]));
    symlink("p.vid", folder.at("link.svg")).unwrap();
    fs::hard_link(folder.at("p.vid"), folder.at("hard.txt")).unwrap();
    let (link, hard) = (folder.name("link.svg"), folder.name("hard.txt"));

    refuses(&["tour", &mesh, "-o", &mesh, "--coverage", "0.3"], &mesh);
    refuses(&["fit", &poses, "-o", &poses], &poses);
    refuses(&["fit", &poses, "--object", &mesh, "-o", &mesh], &mesh);
    refuses(&["sample", &path, "-o", &hard], &path);
    refuses(&["sample", &path, "-o", &link], &path);
    refuses(&["plot", &path, "-o", &link], &path);
    refuses(&["convert", &path, &hard, "--to", "csv"], &path);
    // The path's own object, which it names.
    refuses(&["sample", &path, "-o", &mesh], &mesh);
    refuses(&["reverse", &path, "-o", &mesh], &mesh);
    refuses(&["blend", PYRAMID, &path, "-o", &path], &path);
    refuses(&["insert", PYRAMID, &path, "-o", &path], &path);
    refuses(&["orbit", "--object", &mesh, "-o", &mesh], &mesh);
}

#[test]
fn no_file_of_a_folder_or_of_standard_input_is_overwritten() {
    let folder = Folder::new();
    let gltf = folder.name("scene.gltf");
    let buffer = folder.put("buffer.bin", [0_u8, 0, 0, 7, 0, 0, 0, 7, 0]);
    let text = r#"{"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": [0, 1]}],
        "meshes": [{"primitives": [{"attributes": {"POSITION": 0}}]}],
        "cameras": [{"type": "perspective", "perspective": {"yfov": 0.7, "znear": 0.1}}],
        "nodes": [{"mesh": 0}, {"camera": 0, "translation": [0, 0, 9]}],
        "accessors": [{"bufferView": 0, "componentType": 5121, "count": 3, "type": "VEC3"}],
        "bufferViews": [{"buffer": 0, "byteLength": 9}],
        "buffers": [{"byteLength": 9, "uri": "./buffer.bin"}]}"#;
    fs::write(&gltf, text).unwrap();
    refuses(&["convert", &gltf, &buffer, "--to", "glb"], &buffer);
    // A name with ./ is found, here and in the next conversion.
    let scene = folder.name("scene.vid");
    said(&run(&["convert", &gltf, &scene]));
    let again = said(&run(&["convert", &scene, "-", "--to", "usda"]));
    assert!(again.contains("point3f[] points"), "{again}");

    let model = folder.name("model");
    assert!(
        run(&["convert", PYRAMID, &model, "--to", "colmap"])
            .status
            .success()
    );
    let images = folder.name("model/images.txt");
    refuses(&["convert", &model, &model, "--to", "colmap"], &images);

    let poses = folder.name("poses.txt");
    said(&run(&["sample", PYRAMID, "-o", &poses]));
    let before = fs::read(&poses).unwrap();
    let mut from_input = vides(&["fit", "-", "-o", &poses]);
    from_input.stdin(fs::File::open(&poses).unwrap());
    let told = complaint(&from_input.output().unwrap(), 2);
    assert!(told.contains("overwrite standard input"), "{told}");
    assert_eq!(fs::read(&poses).unwrap(), before);
}

#[test]
fn a_path_is_edited_in_place() {
    let folder = Folder::new();
    let path = folder.put("p.vid", fs::read(PYRAMID).unwrap());
    let last = |path: &str| said(&run(&["get", path, "fps"]));
    said(&run(&["set", &path, "fps=30"]));
    assert_eq!(last(&path).trim(), "30.0");
    said(&run(&["set", &path, "fps=40", "-o", &path]));
    assert_eq!(last(&path).trim(), "40.0");
    let before = fs::read(&path).unwrap();
    said(&run(&["reverse", &path, "-o", &path]));
    assert!(fs::read(&path).unwrap() != before);
    let found = run(&["check", &path, "--fix", "-o", &path]);
    assert!(matches!(found.status.code(), Some(0 | 3)));
}

#[test]
fn what_a_file_names_elsewhere_is_read_if_it_is_trusted() {
    let folder = Folder::new();
    fs::create_dir(folder.at("in")).unwrap();
    let mesh = folder.put("out.obj", MESH);
    symlink("../out.obj", folder.at("in/link.obj")).unwrap();
    for name in ["../out.obj", "link.obj", &mesh] {
        let path = folder.put("in/p.vid", path_with(name));
        let output = run(&["info", &path]);
        let told = String::from_utf8(output.stderr).unwrap();
        let expected = format!(
            "vides: {path}: {name} lies outside the folder of the file that names it and was not \
             read\nvides: {path}: with --trust it is read\n"
        );
        assert_eq!(told, expected);
        let told = String::from_utf8(output.stdout).unwrap();
        assert!(!told.contains("Object"), "{told}");
        for trusting in [["--trust", "info", &path], ["info", &path, "--trust"]] {
            let told = said(&run(&trusting));
            assert!(
                told.contains("Object       4 points") || told.contains("Object"),
                "{told}"
            );
        }
    }
    // What a person names is read from anywhere.
    let path = folder.put("in/p.vid", fs::read(PYRAMID).unwrap());
    said(&run(&[
        "plot",
        &path,
        "--object",
        &mesh,
        "-o",
        &folder.name("in/p.svg"),
    ]));
}

/// The command with the signals that a terminal gives it: who tests in the background ignores some.
fn in_a_terminal(arguments: &[&str]) -> Command {
    let mut command = Command::new("env");
    let signals = "--default-signal=HUP,INT,QUIT,TERM";
    command.args([signals, env!("CARGO_BIN_EXE_vides")]);
    command.args(arguments).stdin(Stdio::null());
    command
}

/// However it ends while it writes, nothing but the old file is there.
#[test]
fn nothing_is_left_behind_by_a_signal() {
    let folder = Folder::new();
    let out = folder.put("out.txt", "old");
    for signal in ["INT", "TERM", "HUP", "KILL", "XFSZ", "QUIT"] {
        let mut child = in_a_terminal(&["sample", PYRAMID, "--move-frames", "4e6", "-o", &out])
            .spawn()
            .unwrap();
        let writing = || {
            let open = fs::read_dir(format!("/proc/{}/fd", child.id())).unwrap();
            let mut files = open.flatten().flat_map(|entry| fs::metadata(entry.path()));
            files.any(|file| file.is_file() && file.len() > 1 << 20)
        };
        let start = Instant::now();
        while !writing() {
            assert!(start.elapsed() < Duration::from_secs(60));
            std::thread::sleep(Duration::from_millis(5));
        }
        let process = child.id().to_string();
        let killed = Command::new("kill").args(["-s", signal, &process]).status();
        assert!(killed.unwrap().success());
        if signal == "XFSZ" {
            // It goes on, and sees that a file may not grow.
            let killed = Command::new("kill").args(["-s", "TERM", &process]).status();
            assert!(killed.unwrap().success());
        }
        assert!(!child.wait().unwrap().success());
        assert_eq!(
            folder.names(),
            BTreeSet::from(["out.txt".to_owned()]),
            "{signal}"
        );
        assert_eq!(fs::read(&out).unwrap(), b"old");
    }
}

#[test]
fn a_limit_of_file_size_is_told() {
    let folder = Folder::new();
    let out = folder.put("out.txt", "old");
    let limited = format!(
        "ulimit -f 100; exec {} sample {PYRAMID} --move-frames 1e4 -o {out}",
        env!("CARGO_BIN_EXE_vides")
    );
    let output = Command::new("sh").args(["-c", &limited]).output().unwrap();
    assert_eq!(
        sentence(&output, 1),
        format!("vides: {out}: File too large\n")
    );
    assert_eq!(folder.names().len(), 1);
    assert_eq!(fs::read(&out).unwrap(), b"old");
}

/// Root alone can try it: the owner changes, and the rights to act as the old one go.
#[test]
fn rights_to_act_as_another_user_go_with_the_owner() {
    const NOBODY: u32 = 65534;
    let folder = Folder::new();
    let path = folder.put("p.vid", fs::read(PYRAMID).unwrap());
    let program = folder.name("vides");
    fs::copy(env!("CARGO_BIN_EXE_vides"), &program).unwrap();
    let allow = |name: &str, mode| {
        fs::set_permissions(name, fs::Permissions::from_mode(mode)).unwrap();
    };
    if chown(folder.at("p.vid"), Some(0), Some(0)).is_err() {
        return;
    }
    allow(folder.0.path().to_str().unwrap(), 0o777);
    for (mode, kept) in [(0o6777, 0o777), (0o676, 0o666), (0o6757, 0o777)] {
        chown(folder.at("p.vid"), Some(0), Some(0)).unwrap();
        allow(&path, mode);
        let mut command = Command::new(&program);
        command
            .args(["set", &path, "fps=30"])
            .uid(NOBODY)
            .gid(NOBODY);
        said(&command.output().unwrap());
        let now = fs::metadata(&path).unwrap();
        use std::os::unix::fs::MetadataExt;
        assert_eq!((now.uid(), now.gid()), (NOBODY, NOBODY));
        assert_eq!(now.mode() & 0o7777, kept, "{mode:o}");
    }
}

#[test]
fn outputs_may_be_devices_and_descriptors() {
    let folder = Folder::new();
    let reversed = said(&run(&["reverse", PYRAMID]));
    for name in ["/dev/stdout", "/dev/fd/1", "/proc/self/fd/1"] {
        assert_eq!(said(&run(&["reverse", PYRAMID, "-o", name])), reversed);
        // A file behind it is written on, not replaced.
        let file = fs::File::create(folder.at("log")).unwrap();
        let status = vides(&["reverse", PYRAMID, "-o", name])
            .stdout(file)
            .status();
        assert!(status.unwrap().success());
        assert_eq!(fs::read_to_string(folder.at("log")).unwrap(), reversed);
    }
    for arguments in [
        &["reverse", PYRAMID][..],
        &["sample", PYRAMID],
        &["set", PYRAMID, "fps=30"],
        &["check", PYRAMID, "--fix"],
    ] {
        let whole = [arguments, &["-o", "/dev/null"]].concat();
        let output = run(&whole);
        assert!(matches!(output.status.code(), Some(0 | 3)), "{whole:?}");
        assert_eq!(output.stderr, b"", "{whole:?}");
    }
    let plot = run(&["plot", PYRAMID, "-o", "/dev/null"]);
    assert_eq!(said(&plot), "");
}

/// Marks that turn the direction of writing make a text look like another.
#[test]
fn nothing_turns_the_writing_of_a_terminal() {
    let turned = |text: &[u8]| {
        let text = String::from_utf8_lossy(text);
        text.contains(['\u{202e}', '\u{2066}', '\u{200f}', '\u{2028}'])
    };
    let folder = Folder::new();
    let text = "version = 1\ntitle = \"a\u{202e}b\"\ncomment = \"c\u{2066}d\u{2028}e\"\n\
                [[point]]\nname = \"f\u{200f}g\"\nposition = [0, 0, 0]\n\
                [[point]]\nposition = [0, 0, 0]\n[object]\nfile = \"h\u{202e}i.obj\"\n";
    let path = folder.put("p\u{202e}q.vid", text);
    let broken = folder.put("r.vid", "version = 1\n\"s\u{202e}t\" = 1\n");
    for arguments in [
        &["info", &path][..],
        &["info", &path, "--json"],
        &["check", &path],
        &["check", &path, "--json"],
        &["get", &path],
        &["get", &path, "title"],
        &["retime", &path, "-o", "/dev/null"],
        &["info", &broken],
        &["info", "/no/u\u{202e}v.vid"],
    ] {
        let output = run(arguments);
        assert!(
            !turned(&output.stdout) && !turned(&output.stderr),
            "{arguments:?}"
        );
    }
    // What is written is the same text.
    let copy = folder.name("copy.vid");
    assert!(run(&["set", &path, "fps=25", "-o", &copy]).status.success());
    let title = Document::load(Path::new(&copy))
        .unwrap()
        .info()
        .title
        .clone();
    assert_eq!(title, "a\u{202e}b");
}

/// A few bytes that ask for as many frames as there may be: they cost time, but no memory, and the
/// user ends it.
#[test]
fn the_longest_film_takes_no_memory_and_is_ended() {
    let folder = Folder::new();
    let film = "version = 1\n[[point]]\nposition = [0, 0, 0]\n[[point.orientation]]\n\
                offset = [0, 0, -1]\nframes = 99999999\n[[point]]\nposition = [0.5, 0, 0]\n";
    let path = folder.put("film.vid", film);
    let most = sentence(&run(&["steady", &path, "--period", "1"]), 1);
    assert!(most.contains("at most 1000000 frames"), "{most}");
    for arguments in [&["check", &path][..], &["plot", &path]] {
        let mut child = in_a_terminal(arguments)
            .stdout(Stdio::null())
            .spawn()
            .unwrap();
        std::thread::sleep(Duration::from_secs(2));
        let status = fs::read_to_string(format!("/proc/{}/status", child.id())).unwrap();
        let peak = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
        let peak = peak.and_then(|peak| peak.trim().strip_suffix(" kB"));
        let peak: usize = peak.unwrap().parse().unwrap();
        assert!(peak < 200_000, "{arguments:?}: {peak} kB");
        let start = Instant::now();
        let process = child.id().to_string();
        Command::new("kill")
            .args(["-s", "INT", &process])
            .status()
            .unwrap();
        child.wait().unwrap();
        assert!(start.elapsed() < Duration::from_secs(2), "{arguments:?}");
    }
    // One more is refused where it is set, not where it is used.
    let more = folder.put("more.vid", film.replace("99999999", "100000000"));
    let told = sentence(&run(&["info", &more]), 1);
    assert!(told.contains("must lie between 0 and 99999999"), "{told}");
}
