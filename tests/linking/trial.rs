//! A library that goes through the same mill as libvides and does what
//! libvides never does in a test: it panics. It also touches the system in
//! every way that Rust's standard library offers a library of this kind.
use std::collections::HashMap;
use std::ffi::{CStr, c_char, c_int};
use std::io::{self, Read, Seek, Write};
use std::panic::catch_unwind;
use std::path::Path;
use std::{env, fs, thread, time};

struct Dropped<'a>(&'a mut c_int);

impl Drop for Dropped<'_> {
    fn drop(&mut self) {
        *self.0 += 1;
    }
}

/// 2 when the panic was caught and the frames on its way were cleaned up.
#[unsafe(no_mangle)]
pub extern "C" fn v_trial_panic() -> c_int {
    let mut dropped = 0;
    let caught = catch_unwind(std::panic::AssertUnwindSafe(|| {
        let _frame = Dropped(&mut dropped);
        let none: Option<c_int> = std::hint::black_box(None);
        none.expect("this panic is part of the test")
    }));
    dropped + c_int::from(caught.is_err())
}

/// 0 when files, folders, time, environment and threads all work in `folder`.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn v_trial_system(folder: *const c_char) -> c_int {
    // SAFETY: the test hands over a C string.
    let folder = unsafe { CStr::from_ptr(folder) }.to_str().unwrap_or(".");
    match system(Path::new(folder)) {
        Ok(()) => 0,
        Err(error) => {
            eprintln!("trial: {error}");
            1
        }
    }
}

fn system(folder: &Path) -> io::Result<()> {
    let start = time::Instant::now();
    let text = "seven";
    let draft = folder.join("draft");
    let file = folder.join("file");
    let mut out = fs::File::create(&draft)?;
    out.write_all(text.as_bytes())?;
    out.sync_all()?;
    fs::set_permissions(&draft, fs::metadata(&draft)?.permissions())?;
    fs::rename(&draft, &file)?;
    fs::File::open(folder)?.sync_all()?;

    let mut back = String::new();
    let mut input = fs::File::open(fs::canonicalize(&file)?)?;
    input.read_to_string(&mut back)?;
    input.seek(io::SeekFrom::Start(1))?;
    let names: HashMap<_, _> = fs::read_dir(folder)?
        .filter_map(|entry| entry.ok())
        .map(|entry| (entry.file_name(), entry.path()))
        .collect();
    fs::remove_file(&file)?;

    let other = thread::Builder::new().spawn(|| thread::current().id())?;
    thread::sleep(time::Duration::from_millis(1));
    let elsewhere = other.join().is_ok_and(|id| id != thread::current().id());
    let told = env::var("VIDES_TRIAL").is_ok_and(|value| value == "told");
    let rounded = std::hint::black_box(2.5_f64).round().hypot(4.0).cbrt();
    let good = back == text
        && names.contains_key(std::ffi::OsStr::new("file"))
        && elsewhere
        && told
        && (rounded - 5.0_f64.powf(1.0 / 3.0)).abs() < 1e-15
        && start.elapsed() >= time::Duration::from_millis(1)
        && std::process::id() > 0;
    if good { Ok(()) } else { Err(io::Error::other("a result is wrong")) }
}
