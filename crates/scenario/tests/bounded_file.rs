//! Names of files that could hang the program: pipes, devices, endless files, folders.

use std::fs;
use std::path::{Path, PathBuf};

use fenderline_scenario::{FileFault, LoadError, Scenario, read_bytes, read_text};

fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder for the test");
    folder
}

fn fault(path: &Path, largest_bytes: u64) -> FileFault {
    read_bytes(path, largest_bytes).expect_err("it must be refused").fault
}

#[test]
fn a_file_is_read_up_to_its_bound_and_not_a_byte_more() {
    let folder = folder("bound");
    let path = folder.join("ten");
    fs::write(&path, b"0123456789").expect("written");
    assert_eq!(read_bytes(&path, 10).expect("ten bytes"), b"0123456789");
    assert_eq!(fault(&path, 9), FileFault::TooLarge { largest_bytes: 9 });
    assert_eq!(fault(&folder, 9), FileFault::NotRegular("a folder"));
    assert!(matches!(fault(&folder.join("none"), 9), FileFault::System { .. }));
    fs::write(&path, b"a\nb\n\xff").expect("written");
    assert!(read_text(&path).expect_err("no text").contains("line 3 is not UTF-8"));
}

#[cfg(unix)]
#[test]
fn a_pipe_as_a_file_does_not_hang() {
    let path = folder("pipe").join("pipe");
    let made = std::process::Command::new("mkfifo").arg(&path).status().expect("mkfifo");
    assert!(made.success());
    assert_eq!(fault(&path, 9), FileFault::NotRegular("a pipe"));
    let link = path.with_file_name("link.toml");
    std::os::unix::fs::symlink(&path, &link).expect("a link");
    assert_eq!(fault(&link, 9), FileFault::NotRegular("a pipe"));
    let Err(LoadError::Unreadable(why)) = Scenario::load(&link, &[]) else { panic!("it is read") };
    assert!(why.contains("link.toml: it is a pipe"), "{why}");
}

#[cfg(target_os = "linux")]
#[test]
fn devices_sockets_and_endless_files_are_refused() {
    for device in ["/dev/zero", "/dev/null", "/dev/tty"] {
        let device = Path::new(device);
        if device.exists() {
            assert_eq!(fault(device, 9), FileFault::NotRegular("a device"), "{device:?}");
        }
    }
    let socket = folder("socket").join("socket");
    let _listener = std::os::unix::net::UnixListener::bind(&socket).expect("a socket");
    assert_eq!(fault(&socket, 9), FileFault::NotRegular("a socket"));
    // Its metadata say a regular file of no bytes, but it has content.
    let endless = Path::new("/proc/self/environ");
    if fs::read(endless).is_ok_and(|bytes| bytes.len() > 9) {
        assert_eq!(fault(endless, 9), FileFault::TooLarge { largest_bytes: 9 });
    }
}
