//! Damages recordings at random, from a seed, as disks, networks, editors and attackers may damage them. Tests of the
//! program also use this module.

/// Random numbers from a seed: SplitMix64 (Steele, Lea & Flood, 2014).
#[derive(Clone, Debug)]
pub(crate) struct Random(u64);

impl Random {
    pub(crate) fn new(seed: u64) -> Random {
        Random(seed)
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number below `bound`, which is not 0.
    pub(crate) fn below(&mut self, bound: usize) -> usize {
        (self.next() % bound as u64) as usize
    }
}

/// A damaged recording and the kind of damage. Its bytes always differ from those of the sound recording.
pub(crate) fn damaged(sound: &[u8], seed: u64) -> (&'static str, Vec<u8>) {
    let mut random = Random::new(seed);
    loop {
        let mut bytes = sound.to_vec();
        let what = damage(&mut bytes, &mut random);
        if bytes != sound {
            return (what, bytes);
        }
    }
}

fn damage(bytes: &mut Vec<u8>, random: &mut Random) -> &'static str {
    let length = bytes.len();
    let at = random.below(length);
    match random.below(16) {
        0..=2 => {
            bytes[at] ^= 1 << random.below(8);
            "one bit flipped"
        }
        3 => {
            for _ in 0..2 + random.below(20) {
                let at = random.below(length);
                bytes[at] ^= 1 << random.below(8);
            }
            "bits flipped"
        }
        4 => {
            bytes[at] = b"0123456789abcdef-.,{}\"\n\r\0 "[random.below(26)];
            "another character"
        }
        5 => {
            bytes.remove(at);
            "a byte lost"
        }
        6 => {
            bytes.insert(at, random.below(256) as u8);
            "a byte too many"
        }
        7 => {
            let end = length.min(at + 1 + random.below(4096));
            bytes[at..end].fill(0);
            "a block of zeros"
        }
        8 => {
            bytes.truncate(at);
            "cut off"
        }
        9 => {
            let end = bytes[..at].iter().rposition(|b| *b == b'\n').map_or(0, |end| end + 1);
            bytes.truncate(end);
            "cut off between two lines"
        }
        10 => {
            let end = length.min(at + 1 + random.below(4096));
            let block = bytes[at..end].to_vec();
            let to = random.below(length);
            bytes.splice(to..to, block);
            "a block twice"
        }
        11 => {
            let end = length.min(at + 1 + random.below(4096));
            bytes.drain(at..end);
            "a block lost"
        }
        12 => {
            let tail = bytes[at..].to_vec();
            bytes.extend(tail);
            "its tail twice"
        }
        number => {
            let mut lines: Vec<&[u8]> = bytes.split_inclusive(|b| *b == b'\n').collect();
            let at = random.below(lines.len());
            let what = match number {
                13 => {
                    lines.remove(at);
                    "a line lost"
                }
                14 => {
                    lines.insert(at, lines[at]);
                    "a line twice"
                }
                _ => {
                    let other = random.below(lines.len());
                    lines.swap(at, other);
                    "two lines swapped"
                }
            };
            *bytes = lines.concat();
            what
        }
    }
}

/// The end of a line after the line's own fields.
const TAIL: usize = r#","sum":"00000000"}"#.len();

/// The lines of a sound recording without their check sums.
pub(crate) fn objects(sound: &str) -> Vec<String> {
    sound.lines().map(|line| format!("{}}}", &line[..line.len() - TAIL])).collect()
}

/// Lines with correct check sums and any content, as an attacker can make them.
pub(crate) fn sealed<'l>(objects: impl IntoIterator<Item = &'l str>) -> String {
    let mut text = String::new();
    let mut chain = 0;
    for object in objects {
        let body = &object[..object.len() - 1];
        let mut sum = crc32fast::Hasher::new_with_initial(chain);
        sum.update(body.as_bytes());
        chain = sum.finalize();
        text += &format!("{body},\"sum\":\"{chain:08x}\"}}\n");
    }
    text
}

/// A recording with other numbers in some lines after the first, and correct check sums.
pub(crate) fn forged(sound: &str, seed: u64) -> String {
    let mut random = Random::new(seed);
    let mut objects = objects(sound);
    for _ in 0..1 + random.below(4) {
        let at = 1 + random.below(objects.len() - 1);
        objects[at] = with_another_number(&objects[at], &mut random);
    }
    if random.below(3) == 0 {
        let at = 1 + random.below(objects.len() - 1);
        let other = objects[1 + random.below(objects.len() - 1)].clone();
        objects.insert(at, other);
    }
    sealed(objects.iter().map(String::as_str))
}

fn with_another_number(object: &str, random: &mut Random) -> String {
    const OTHERS: [&str; 14] = [
        "0",
        "1",
        "-1",
        "7",
        "100",
        "199999",
        "1000000000000000000",
        "9223372036854775808",
        "18446744073709551615",
        "1e18",
        "1e308",
        "-0.0",
        "0.5",
        "null",
    ];
    let starts: Vec<usize> = object
        .match_indices(':')
        .map(|(at, _)| at + 1)
        .filter(|at| object[*at..].starts_with(|c: char| c == '-' || c.is_ascii_digit()))
        .collect();
    if starts.is_empty() {
        return object.to_owned();
    }
    let start = starts[random.below(starts.len())];
    let end = object[start..].find([',', '}']).map_or(object.len(), |end| start + end);
    let other = OTHERS[random.below(OTHERS.len())];
    format!("{}{other}{}", &object[..start], &object[end..])
}
