//! Errors of the container, with the place in the file that they come of.

use vides_document::mesh::gltf::Container;
use vides_document::mesh::{Error as MeshError, Problem};
use vides_engine::limits::{MAX_FILE_BYTES, MAX_SCENE_NUMBERS};

use crate::error::{Cause, Error, Place, Wanted};
use crate::source::Source;
use crate::tree::{self, At};

/// Errors of the container, which know no more than their reason.
pub(super) fn wrong(error: MeshError) -> Error {
    vides_document::Error::from(error).into()
}

/// The same, of what stands at a place.
pub(super) fn wrong_at(at: At<'_>, error: MeshError) -> Error {
    match error {
        MeshError::File(Problem::Format) => at.wrong(Cause::Syntax("this is malformed".into())),
        MeshError::File(Problem::Indices) => {
            at.wrong(Cause::Syntax("the file has no such number".into()))
        }
        MeshError::File(problem) => at.wrong(Cause::Syntax((&problem).into())),
        other => wrong(other),
    }
}

/// Why a file cannot be opened.
pub(super) fn of_file(source: &Source, error: MeshError) -> Error {
    let version = |name: &str| Cause::Unsupported {
        name: format!("glTF {name}").as_str().into(),
        help: "",
    };
    if let [b'g', b'l', b'T', b'F', number, ..] = source.bytes[..] {
        return match number {
            2 => wrong(error),
            _ => Place::Whole.wrong(version(&number.to_string())),
        };
    }
    let begin = source.bytes.trim_ascii_start().first();
    if begin.is_some_and(|begin| !matches!(begin, b'{' | b'\xef')) {
        return Place::Whole.wrong(Cause::Expected(Wanted::Literal("glTF")));
    }
    let json = match tree::parse(&source.bytes) {
        Ok(json) => json,
        Err(error) => return error,
    };
    let root = At::root(&json);
    if let Some(at) = root.get("asset").and_then(|asset| asset.get("version"))
        && let Some(name) = at.value.as_str().filter(|name| !name.starts_with("2."))
    {
        return at.wrong(version(&name.chars().take(16).collect::<String>()));
    }
    let is_gone = |at: &At<'_>| {
        let name = at.value.as_str().filter(|name| !name.starts_with("data:"));
        name.is_some_and(|name| source.beside(name, MAX_FILE_BYTES).is_err())
    };
    let buffers = root.get("buffers").and_then(|list| list.list().ok());
    let mut names = buffers.into_iter().flatten().filter_map(|at| at.get("uri"));
    match (&error, names.find(is_gone)) {
        (MeshError::File(Problem::Buffer), Some(gone)) => wrong_at(gone, error),
        _ => wrong(error),
    }
}

/// Why the nodes are no tree.
pub(super) fn of_tree(root: At<'_>, error: MeshError) -> Error {
    let lists = |key, list| {
        let all = root.get(key).and_then(|all: At<'_>| all.list().ok());
        let found = all.into_iter().flatten();
        let found = found.filter_map(move |at| at.get(list)?.list().ok());
        found.flatten()
    };
    let nodes = root.get("nodes").and_then(|all| all.value.as_array());
    let mut seen = vec![false; nodes.map_or(0, Vec::len)];
    for child in lists("scenes", "nodes") {
        if let Err(error) = node(root, child) {
            return error;
        }
    }
    for child in lists("nodes", "children") {
        match node(root, child) {
            Err(error) => return error,
            Ok(at) if std::mem::replace(&mut seen[at], true) => return wrong_at(child, error),
            Ok(_) => {}
        }
    }
    wrong(error)
}

/// The number of a node that there is.
fn node(root: At<'_>, at: At<'_>) -> Result<usize, Error> {
    let index = at.index()?;
    let nodes = root.get("nodes").and_then(|all| all.value.as_array());
    let count = nodes.map_or(0, Vec::len);
    match index < count {
        true => Ok(index),
        false => Err(at.wrong(Cause::Index {
            index: index as u64,
            count,
        })),
    }
}

/// Why a node has no place: the first of its numbers that are wrong.
pub(super) fn of_place(at: At<'_>, error: MeshError) -> Error {
    let triple = |key| at.get(key).and_then(|at: At<'_>| at.numbers::<3>().err());
    let rotation = || at.get("rotation")?.numbers::<4>().err();
    let matrix = || at.get("matrix")?.numbers::<16>().err();
    let known = matrix().or_else(|| triple("translation"));
    let known = known.or_else(rotation).or_else(|| triple("scale"));
    known.unwrap_or_else(|| wrong_at(at, error))
}

/// Why a mesh cannot be read: the first accessor that cannot, if there is one.
pub(super) fn of_mesh(container: &Container<'_>, mesh: At<'_>, error: MeshError) -> Error {
    let fails = |at: At<'_>| container.accessor(at.value, MAX_SCENE_NUMBERS).is_err();
    let primitives = mesh.get("primitives").and_then(|list| list.list().ok());
    for primitive in primitives.into_iter().flatten() {
        let attributes = primitive.get("attributes");
        let names = attributes.and_then(|all| all.value.as_object());
        let names = names.into_iter().flatten().map(|(name, _)| name);
        let accessors = names.filter_map(|name| attributes?.get(name));
        if let Some(at) = accessors
            .chain(primitive.get("indices"))
            .find(|at| fails(*at))
        {
            return wrong_at(at, error);
        }
    }
    wrong_at(mesh, error)
}
