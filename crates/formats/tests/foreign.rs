//! Files of other programs that VIDES does not read are named, with the way to one that it reads.

use vides_formats::{Error, Options, Source, import};

/// A name that says nothing, and the beginning of a file as its program writes it.
const CONTENTS: [(&str, &[u8]); 56] = [
    ("FBX", b"Kaydara FBX Binary  \0\x1a\0"),
    ("FBX", b"; FBX 7.3.0 project file\n"),
    ("FBX", b"\n; Created by a program\nFBXHeaderExtension:  {\n"),
    ("Alembic", b"Ogawa\xff\0\x01"),
    ("Blender", b"BLENDER-v405REND"),
    ("Maya", b"//Maya ASCII 2022 scene\n"),
    ("Maya", b"FOR4\0\0\x01\x44Maya"),
    ("Maya", b"FOR8\0\0\0\0\0\0\0\0\0\0\x01\x44Maya"),
    ("Cinema 4D", b"QC4DC4D6"),
    ("LightWave", b"LWSC\n5\n"),
    ("Unity", b"%YAML 1.1\n%TAG !u! tag:unity3d.com,2011:\n"),
    ("BVH", b"HIERARCHY\nROOT Hips\n{\n"),
    ("BVH", b"\xef\xbb\xbf\r\nHIERARCHY\r\nROOT Hips\r\n"),
    (
        "Collada",
        b"<?xml version=\"1.0\"?>\n<COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\">",
    ),
    ("VRML", b"#VRML V2.0 utf8\n"),
    ("X3D", b"<?xml version=\"1.0\"?>\n<X3D profile='Immersive'>"),
    ("ROS bag", b"#ROSBAG V2.0\nE\0\0\0"),
    ("MCAP", b"\x89MCAP0\r\n"),
    (
        "ROS 2 bag",
        b"SQLite format 3\0\x10\0\0\xff\xfeCREATE TABLE topics(id INTEGER PRIMARY KEY,name TEXT)",
    ),
    (
        "COLMAP database",
        b"SQLite format 3\0\x10\0\0\xff\xfeCREATE TABLE two_view_geometries (pair_id INTEGER)",
    ),
    ("SQLite", b"SQLite format 3\0\x10\0\0\xff\xfeCREATE TABLE a(b)"),
    ("Bundler", b"# Bundle file v0.3\n2 0\n"),
    ("VisualSFM", b"NVM_V3 \n\n2\n"),
    ("OpenMVG", b"{\n    \"sfm_data_version\": \"0.3\",\n"),
    ("OpenSfM", b"[{\"cameras\": {}, \"shots\": {\"a.jpg\": {\"rotation\": [0, 0, 0]}}}]"),
    ("AliceVision", b"{\"version\": [\"1\"], \"featuresFolders\": [], \"views\": []}"),
    (
        "Metashape",
        b"<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<document version=\"2.0.0\">\n  <chunk label=\"Chunk 1\" enabled=\"true\">",
    ),
    ("ContextCapture", b"<?xml version=\"1.0\"?>\n<BlocksExchange version=\"2.1\">"),
    ("MeshLab", b"<!DOCTYPE MeshLabDocument>\n<MeshLabProject>\n <MeshGroup>"),
    ("MeshLab", b"<!DOCTYPE ViewState>\n<project>\n <VCGCamera TranslationVector=\"0 0 0 1\"/>"),
    ("ParaView camera", b"<?xml version=\"1.0\"?>\n<PVCameraConfiguration description=\"a\">"),
    ("ParaView state", b"<ParaView>\n  <ServerManagerState version=\"5.11.0\">"),
    (
        "ParaView trace",
        b"# trace generated using paraview version 5.11.0\nfrom paraview.simple import *\n",
    ),
    ("Mitsuba", b"<scene version=\"3.0.0\">\n"),
    ("POV-Ray", b"#version 3.7;\nglobal_settings { assumed_gamma 1.0 }\n"),
    ("POV-Ray", b"#include \"colors.inc\"\ncamera { location <0, 1, -3> look_at 0 }\n"),
    ("After Effects project", b"RIFX\0\0\x01\0Egg!"),
    ("After Effects project", b"<?xml version=\"1.0\"?>\n<AfterEffectsProject xmlns=\"a\">"),
    ("After Effects keyframe", b"Adobe After Effects 8.0 Keyframe Data\r\n\r\n\tUnits Per Second\t25\r\n"),
    ("Nuke", b"#! /opt/Nuke13.0/libnuke-13.0.so -nx\nversion 13.0 v3\nRoot {\n"),
    ("Nuke", b"set cut_paste_input [stack 0]\nversion 13.0 v3\nCamera2 {\n"),
    ("KML", b"<?xml version=\"1.0\"?>\n<kml xmlns=\"http://www.opengis.net/kml/2.2\">"),
    ("KMZ", b"PK\x03\x04\x14\0\0\0\x08\0aaaaaaaaaaaaaaaa\x07\0\0\0doc.kml"),
    ("GPX", b"<?xml version=\"1.0\"?>\n<gpx version=\"1.1\" creator=\"a\">"),
    ("CZML", b"[{\"id\": \"document\", \"version\": \"1.0\"}, {\"position\": {\"cartesian\": []}}]"),
    ("CZML", b"[{\"id\":\"document\",\"name\":\"CZML\",\"version\":\"1.0\"}]"),
    ("SRT", b"1\n00:00:00,000 --> 00:00:00,033\n[latitude: 50.1]\n"),
    ("SRT", b"\xef\xbb\xbf1\r\n00:00:01,001 --> 00:00:02,000\r\nHOME(8.6,50.1)\r\n"),
    ("NMEA", b"$GPGGA,123519,4807.038,N,01131.000,E,1,08,0.9,545.4,M,46.9,M,,*47\n"),
    ("Earth Studio", b"{\"width\":1920,\"height\":1080,\"numFrames\":2,\"cameraFrames\":[{\"position\":{\"x\":1,\"y\":2,\"z\":3}}]}"),
    ("ULog", b"ULog\x01\x12\x35\x01"),
    ("LAS", b"LASF\0\0"),
    ("E57", b"ASTM-E57\x01\0"),
    ("ZIP", b"PK\x03\x04\x14\0\0\0\x08\0aaaaaaaaaaaaaaaa\x05\0\0\0a.txt"),
    ("gzip", b"\x1f\x8b\x08\0"),
    ("Zstandard", b"\x28\xb5\x2f\xfd\x04"),
];

/// Of a content that says nothing, the ending decides.
const ENDINGS: [(&str, &str, &[u8]); 24] = [
    ("ROS 2 bag", "a.db3", b"SQLite format 3\0"),
    ("COLMAP database", "database.db", b"SQLite format 3\0"),
    ("FBX", "a.fbx", b"\0\0"),
    ("Alembic", "a.abc", b"\x89HDF\r\n\x1a\n"),
    ("Blender", "a.blend", b"\x28\xb5\x2f\xfd\x04"),
    ("Blender", "A.BLEND", b"\x1f\x8b\x08\0"),
    ("Maya", "a.ma", b"requires maya \"2022\";\n"),
    ("3ds Max", "a.max", b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1"),
    ("Houdini", "a.hip", b"070707\0"),
    ("Record3D", "a.r3d", b"PK\x03\x04\x14\0"),
    ("KMZ", "a.kmz", b"PK\x03\x04\x14\0"),
    ("Metashape", "a.psz", b"PK\x03\x04\x14\0"),
    (
        "Metashape",
        "a.psx",
        b"<document version=\"1.2.0\" path=\"a.files/project.zip\"/>",
    ),
    ("Earth Studio", "a.esp", b"{\"modelVersion\": 18}"),
    (
        "POV-Ray",
        "a.pov",
        b"camera { location <0, 1, -3> look_at 0 }\n",
    ),
    ("Nuke", "a.nk", b"Camera2 {\n inputs 0\n}\n"),
    ("MeshLab", "a.mlp", b""),
    ("ParaView camera", "a.pvcc", b""),
    ("SRT", "a.srt", b""),
    ("GPX", "a.gpx", b""),
    ("CZML", "a.czml", b"[]"),
    ("Collada", "a.dae", b"<a>"),
    ("BVH", "a.bvh", b"\n"),
    ("ROS bag", "a.bag", b""),
];

fn sentence(file: &str, bytes: &[u8]) -> String {
    let source = Source::of_bytes(file, bytes.to_vec());
    match import(&source, None, &Options::default()) {
        Err(Error::In(_, error)) => error.to_string(),
        other => format!("{other:?}"),
    }
}

#[test]
fn files_of_other_programs_are_named_by_their_content() {
    let mut wrong = Vec::new();
    for (kind, bytes) in CONTENTS {
        for file in ["file", "a.tum", "a.json"] {
            let said = sentence(file, bytes);
            if !said.starts_with(&format!("{kind} files are not read: ")) {
                wrong.push(format!("{kind}, {file}: {said}"));
            }
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn files_of_other_programs_are_named_by_their_ending_where_the_content_says_nothing() {
    let mut wrong = Vec::new();
    for (kind, file, bytes) in ENDINGS {
        let said = sentence(file, bytes);
        if !said.starts_with(&format!("{kind} files are not read: ")) {
            wrong.push(format!("{kind}, {file}: {said}"));
        }
    }
    assert!(wrong.is_empty(), "{wrong:#?}");
}

#[test]
fn poses_are_read_whatever_the_ending_is() {
    let line = "0,0,0,0,1,0,0,0\n";
    let euroc = format!("#timestamp,p_x,p_y,p_z,q_w,q_x,q_y,q_z\n{line}");
    for file in ["a.fbx", "a.srt", "a.pov"] {
        let source = Source::of_bytes(file, euroc.clone().into());
        let read = import(&source, None, &Options::default()).unwrap();
        assert_eq!(read.format, "euroc");
    }
}

/// What the program's own tool can do is said by its name.
#[test]
fn the_way_is_one_that_there_is() {
    for (bytes, way) in [
        (
            &b"Kaydara FBX Binary"[..],
            "export glTF from the program that made it",
        ),
        (
            b"set cut_paste_input [stack 0]",
            "export the camera as .chan from Nuke",
        ),
        (
            b"<chunk label=\"a\">",
            "export the cameras as XML, and make transforms.json of them with \"ns-process-data metashape\"",
        ),
        (
            b"[{\"shots\": {}}]",
            "export a COLMAP model with \"opensfm export_colmap\", and name its folder",
        ),
        (
            b"SQLite format 3\0CREATE TABLE two_view_geometries (",
            "they have no poses: name the folder of the model that \"colmap mapper\" makes of them",
        ),
        (
            b"#ROSBAG V2.0",
            "extract the poses, as with \"evo_traj bag in.bag TOPIC --save_as_tum\"",
        ),
        (b"<kml>", "write its poses in metres, as TUM for example"),
        (b"PK\x03\x04", "unpack it"),
        (
            b"PXR-USDC\0",
            "make text of it by `usdcat in.usdc -o out.usda`",
        ),
    ] {
        let said = sentence("file", bytes);
        assert!(said.ends_with(&format!(": {way}")), "{said}");
    }
}
