//! The user's model of a ship: every page of the session gets the file, and nobody else does.

use crate::client;
use crate::server;

use std::fs;

use server::Server;

use super::block_on;

/// A scenario in a folder of its own, with a model of the ship.
fn beside_a_model(name: &str, model: &[u8]) -> std::path::PathBuf {
    let folder = std::env::temp_dir().join(format!("fenderline-{name}-{}", std::process::id()));
    fs::create_dir_all(&folder).expect("a folder");
    let path = folder.join("scene.toml");
    let toml = "[time]\nstep = 0.1\nduration = 60\n[vessel.own]\nfrom = \"bulk-carrier\"\nmodel = \"own.glb\"\n\
                [body.first]\nvessel = \"bulk-carrier\"\nposition = [900, 0]\n\
                [body.ship]\nvessel = \"own\"\nposition = [0, 0]\n";
    fs::write(&path, toml).expect("a scenario");
    fs::write(folder.join("own.glb"), model).expect("a model");
    path
}

#[test]
fn each_page_gets_the_model_of_a_ship_and_a_stranger_does_not() {
    block_on(async {
        let scenario = beside_a_model("model", b"glTF\x02\0\0\0\x10\0\0\0body");
        let server = Server::start_with(&scenario, &["--paused"]);
        let token = server.path("observer");
        let token = token.split_once("token=").expect("a token").1;
        let get = async |query: &str| client::get(&server, &format!("/model?{query}")).await;
        let answer = get(&format!("token={token}&vessel=1")).await;
        let (head, body) = answer.split_once("\r\n\r\n").expect("a head");
        assert!(head.starts_with("HTTP/1.1 200") && head.contains("model/gltf-binary"), "{head}");
        assert!(body.starts_with("glTF") && body.ends_with("body"), "{body}");
        assert!(get("token=wrong&vessel=1").await.starts_with("HTTP/1.1 403"));
        assert!(get("vessel=1").await.starts_with("HTTP/1.1 403"));
        for query in ["vessel=0", "vessel=7", "vessel=x", "vessel=-1", ""] {
            let answer = get(&format!("token={token}&{query}")).await;
            assert!(answer.starts_with("HTTP/1.1 404"), "{query}: {answer}");
        }
        server.interrupt();
        fs::remove_dir_all(scenario.parent().expect("a folder")).expect("removed");
    });
}

#[test]
fn a_file_that_is_no_model_is_refused_before_anything_is_served() {
    let scenario = beside_a_model("no-model", b"PK\x03\x04");
    for command in ["check", "serve"] {
        let ran = server::program().arg(command).arg(&scenario).output().expect("it runs");
        let said = String::from_utf8_lossy(&ran.stderr);
        assert_eq!(ran.status.code(), Some(2), "{command}: {said}");
        assert!(said.contains("does not begin with glTF"), "{command}: {said}");
        assert!(said.contains("scene.toml:6"), "{command}: {said}");
    }
    fs::remove_dir_all(scenario.parent().expect("a folder")).expect("removed");
}
