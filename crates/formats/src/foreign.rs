//! Files of other programs that are not read, each with the way to one that is.
//!
//! A name or a first line identifies a file; the rest is not parsed.

use std::fmt;
use std::path::Path;

/// A kind of file that is not read.
#[derive(Debug, PartialEq, Eq)]
pub struct Foreign {
    /// What people call it.
    pub name: &'static str,
    /// How its cameras come here.
    pub way: Way,
    /// Endings that a file with this content has; none: whatever its name.
    endings: &'static [&'static str],
    /// One of these is at the beginning; none: the ending says it all.
    begins: &'static [&'static [u8]],
    /// One of these is in the first lines, where the beginning alone would not do.
    holds: &'static [&'static str],
}

/// How cameras come out of a file that is not read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Way {
    /// glTF, from the program that made it.
    Gltf,
    /// A list of poses, from the program that made it.
    Poses,
    /// COLMAP's model as text.
    ColmapText,
    /// The poses of a recording, by a program that reads such logs.
    Log,
    /// The metadata in the archive.
    Metadata,
}

impl fmt::Display for Way {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Gltf => "export glTF from the program that made it",
            Self::Poses => "export the poses, as TUM, CSV or transforms.json for example",
            Self::ColmapText => "export the model as text with \"colmap model_converter\"",
            Self::Metadata => {
                "unpack its metadata, with \"unzip -p in.r3d metadata > metadata.json\""
            }
            Self::Log => "extract the poses, as TUM with \"evo_traj\" for example",
        })
    }
}

const fn magic(name: &'static str, way: Way, begins: &'static [&'static [u8]]) -> Foreign {
    Foreign {
        name,
        way,
        endings: &[],
        begins,
        holds: &[],
    }
}

const fn text(name: &'static str, way: Way, holds: &'static [&'static str]) -> Foreign {
    Foreign {
        name,
        way,
        endings: &[],
        begins: &[],
        holds,
    }
}

const fn ending(name: &'static str, way: Way, endings: &'static [&'static str]) -> Foreign {
    Foreign {
        name,
        way,
        endings,
        begins: &[],
        holds: &[],
    }
}

static ALL: [Foreign; 31] = [
    magic("FBX", Way::Gltf, &[b"Kaydara FBX Binary", b"; FBX"]),
    magic("Alembic", Way::Gltf, &[b"Ogawa"]),
    magic("Blender", Way::Gltf, &[b"BLENDER"]),
    magic("Maya", Way::Gltf, &[b"//Maya ASCII", b"FOR4", b"FOR8"]),
    magic("ROS bag", Way::Log, &[b"#ROSBAG"]),
    magic("MCAP", Way::Log, &[b"\x89MCAP"]),
    magic("After Effects project", Way::Poses, &[b"RIFX"]),
    magic("Bundler", Way::Poses, &[b"# Bundle file"]),
    magic("BVH", Way::Gltf, &[b"HIERARCHY"]),
    // One kind of database, two programs.
    Foreign {
        endings: &["db3"],
        ..magic("ROS 2 bag", Way::Log, &[b"SQLite format 3\0"])
    },
    magic("COLMAP database", Way::ColmapText, &[b"SQLite format 3\0"]),
    text("Collada", Way::Gltf, &["<COLLADA"]),
    text("KML", Way::Poses, &["<kml"]),
    text("GPX", Way::Poses, &["<gpx"]),
    text(
        "MeshLab",
        Way::Poses,
        &["MeshLabDocument", "MeshLabProject"],
    ),
    text("ParaView camera", Way::Poses, &["PVCameraConfiguration"]),
    text("ParaView trace", Way::Poses, &["paraview.simple"]),
    text("Metashape", Way::Poses, &["<chunk ", "agisoft"]),
    text("Mitsuba", Way::Poses, &["<scene version="]),
    text(
        "After Effects keyframe",
        Way::Poses,
        &["Adobe After Effects"],
    ),
    text("SRT", Way::Poses, &["00:00:00,000 -->", "00:00:00.000 -->"]),
    text("Earth Studio", Way::Poses, &["cameraFrames"]),
    text("CZML", Way::Poses, &["\"czml\""]),
    text(
        "Nuke",
        Way::Poses,
        &["set cut_paste_input", "window_layout_xml"],
    ),
    ending("KMZ", Way::Poses, &["kmz"]),
    ending("Record3D", Way::Metadata, &["r3d"]),
    ending("Blender", Way::Gltf, &["blend"]),
    ending("Alembic", Way::Gltf, &["abc"]),
    ending("POV-Ray", Way::Poses, &["pov"]),
    ending("Metashape", Way::Poses, &["psx", "psz"]),
    ending("Nuke", Way::Poses, &["nk"]),
];

impl Foreign {
    /// What a file of this name and content is, if it is of a kind that is not read; `head` is the
    /// beginning of the content as text.
    pub(super) fn of(name: &str, bytes: &[u8], head: &str) -> Option<&'static Self> {
        let ending = Path::new(name).extension();
        let ending = ending.map_or_else(String::new, |end| end.to_string_lossy().to_lowercase());
        ALL.iter().find(|kind| {
            let named = kind.endings.contains(&ending.as_str());
            let begins = kind.begins.iter().any(|begin| bytes.starts_with(begin));
            let holds = kind.holds.iter().any(|part| head.contains(part));
            match (kind.begins, kind.holds) {
                ([], []) => named,
                _ => (kind.endings.is_empty() || named) && (begins || holds),
            }
        })
    }
}
