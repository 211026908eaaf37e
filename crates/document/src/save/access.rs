//! Who may follow, replace and read what is saved.

use std::fs::{self, File, Metadata, Permissions};
use std::io;
use std::os::unix::ffi::OsStringExt;
use std::os::unix::fs::{MetadataExt, PermissionsExt, fchown};
use std::path::{Path, PathBuf};

use rustix::fs::{Mode, OFlags, XattrFlags};
use rustix::io::Errno;
use rustix::process::geteuid;

const SET_USER: u32 = 0o4000;
const SET_GROUP: u32 = 0o2000;
const STICKY: u32 = 0o1000;
const OTHERS_WRITE: u32 = 0o002;

/// The extended attribute that holds a file's access control list.
const ACL: &str = "system.posix_acl_access";

/// As many symbolic links as Linux itself follows.
const MAX_LINKS: usize = 40;

/// The folder that a file is in.
pub(super) fn folder_of(file: &Path) -> &Path {
    match file.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    }
}

/// The file to replace: the end of the chain of symbolic links, even if missing.
pub(super) fn destination(file: &Path) -> io::Result<PathBuf> {
    let mut file = file.to_path_buf();
    if file.as_os_str().is_empty() {
        return Err(Errno::NOENT.into());
    }
    for _ in 0..MAX_LINKS {
        match fs::symlink_metadata(&file) {
            Ok(metadata) if metadata.file_type().is_symlink() => {
                let link = read_link(&file)?;
                // Absolute links replace the whole path, relative ones the name.
                file.pop();
                file.push(link);
            }
            Ok(metadata) => {
                refuse_planted(&metadata, &file)?;
                return Ok(file);
            }
            _ => return Ok(file),
        }
    }
    Err(Errno::LOOP.into())
}

/// Where a link leads, if it may be followed. Its owner is that of the link that is read.
fn read_link(file: &Path) -> io::Result<PathBuf> {
    let flags = OFlags::PATH | OFlags::NOFOLLOW | OFlags::CLOEXEC;
    let link = File::from(rustix::fs::open(file, flags, Mode::empty())?);
    refuse_planted(&link.metadata()?, file)?;
    let target = rustix::fs::readlinkat(&link, "", Vec::new())?;
    Ok(std::ffi::OsString::from_vec(target.into_bytes()).into())
}

/// The kernel's rule of `fs.protected_symlinks` and `fs.protected_regular`, wherever they are off
/// and since links are followed here: in a folder like `/tmp` only what is ours or the folder's
/// owner's is followed or replaced.
fn refuse_planted(there: &Metadata, file: &Path) -> io::Result<()> {
    let user = geteuid().as_raw();
    if there.uid() == user {
        return Ok(());
    }
    let folder = fs::metadata(folder_of(file))?;
    let shared = folder.mode() & (STICKY | OTHERS_WRITE) == STICKY | OTHERS_WRITE;
    match shared && there.uid() != folder.uid() {
        true => Err(Errno::ACCESS.into()),
        false => Ok(()),
    }
}

/// Gives a new file the owner, group, access control list and mode of the old one, as far as the
/// system allows it. What was a right of another owner or group is dropped.
pub(super) fn keep(new: &File, old: &File) -> io::Result<()> {
    let was = old.metadata()?;
    // Only root may give a file away; a group that we are in we may give it to.
    if fchown(new, Some(was.uid()), Some(was.gid())).is_err() {
        let _ = fchown(new, None, Some(was.gid()));
    }
    let now = new.metadata()?;
    let mut mode = was.mode() & 0o7777;
    if now.uid() != was.uid() {
        mode &= !SET_USER;
    }
    if now.gid() != was.gid() {
        // Another group has the rights of others only; a list is narrowed by the same bits.
        mode = mode & !(SET_GROUP | 0o070) | (mode & 0o007) << 3;
    }
    match acl(old)? {
        Some(list) => rustix::fs::fsetxattr(new, ACL, &list, XattrFlags::empty())?,
        // The folder may have given it one.
        None => match rustix::fs::fremovexattr(new, ACL) {
            Ok(()) | Err(Errno::NODATA | Errno::OPNOTSUPP) => {}
            Err(error) => return Err(error.into()),
        },
    }
    new.set_permissions(Permissions::from_mode(mode))
}

/// The access control list, if there is one beside the mode.
fn acl(file: &File) -> io::Result<Option<Vec<u8>>> {
    let size = match rustix::fs::fgetxattr_query(file, ACL) {
        Ok(size) => size,
        Err(Errno::NODATA | Errno::OPNOTSUPP) => return Ok(None),
        Err(error) => return Err(error.into()),
    };
    let mut list = vec![0; size];
    let size = rustix::fs::fgetxattr(file, ACL, &mut list[..])?;
    list.truncate(size);
    Ok(Some(list))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A list that lets user 1234 read and write, as the kernel stores it.
    fn list() -> Vec<u8> {
        let mut list = 2_u32.to_le_bytes().to_vec();
        let any = u32::MAX;
        let entries: [(u16, u16, u32); 5] = [
            (0x01, 6, any),
            (0x02, 6, 1234),
            (0x04, 0, any),
            (0x10, 6, any),
            (0x20, 0, any),
        ];
        for (tag, rights, who) in entries {
            list.extend(tag.to_le_bytes());
            list.extend(rights.to_le_bytes());
            list.extend(who.to_le_bytes());
        }
        list
    }

    fn set(file: &Path, name: &str) -> bool {
        let file = File::open(file).unwrap();
        rustix::fs::fsetxattr(&file, name, &list(), XattrFlags::empty()).is_ok()
    }

    fn acl_of(file: &Path) -> Option<Vec<u8>> {
        acl(&File::open(file).unwrap()).unwrap()
    }

    fn mode(file: &Path) -> u32 {
        fs::metadata(file).unwrap().mode() & 0o7777
    }

    #[test]
    fn access_lists_are_kept_and_those_of_the_folder_not_added() {
        let folder = tempfile::tempdir().unwrap();
        let [with, without] = ["with", "without"].map(|name| folder.path().join(name));
        for file in [&with, &without] {
            fs::write(file, "old").unwrap();
            fs::set_permissions(file, Permissions::from_mode(0o640)).unwrap();
        }
        // A file system without such lists has nothing to keep.
        if !set(&with, ACL) || !set(folder.path(), "system.posix_acl_default") {
            return;
        }
        for file in [&with, &without] {
            let new = folder.path().join("new");
            let made = File::create(&new).unwrap();
            keep(&made, &File::open(file).unwrap()).unwrap();
            fs::rename(new, file).unwrap();
        }
        assert_eq!(acl_of(&with), Some(list()));
        assert_eq!(
            mode(&with),
            0o660,
            "the group's bits are those of the list's mask"
        );
        assert_eq!(acl_of(&without), None);
        assert_eq!(mode(&without), 0o640);
    }

    /// Root alone can try it.
    #[test]
    fn rights_of_another_owner_or_group_are_dropped() {
        let folder = tempfile::tempdir().unwrap();
        let [old, new] = ["old", "new"].map(|name| folder.path().join(name));
        let was = File::create(&old).unwrap();
        if fchown(&was, Some(1234), Some(1234)).is_err() {
            return;
        }
        for (mode_of, kept) in [(0o6777, 0o6777), (0o640, 0o640)] {
            was.set_permissions(Permissions::from_mode(mode_of))
                .unwrap();
            let made = File::create(&new).unwrap();
            keep(&made, &was).unwrap();
            let now = made.metadata().unwrap();
            assert_eq!((now.uid(), now.gid()), (1234, 1234));
            assert_eq!(mode(&new), kept);
            fs::remove_file(&new).unwrap();
        }
    }
}
