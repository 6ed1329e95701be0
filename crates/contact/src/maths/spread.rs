//! A sorting method for many entries with evenly spread keys, such as places and ranks. This sorting method uses as
//! many buckets as the list has entries.

use alloc::vec::Vec;

use crate::maths::room::room_for;

/// Buffers for sorting a list of `T`.
#[derive(Clone, Debug, Default)]
pub(crate) struct SpreadSort<T> {
    copy: Vec<T>,
    /// For each bucket, the index at which it begins in the sorted list.
    starts: Vec<u32>,
}

impl<T: Copy> SpreadSort<T> {
    /// Makes buffers with room for lists of this number of entries.
    pub(crate) fn with_room(count: usize) -> SpreadSort<T> {
        SpreadSort { copy: room_for(count), starts: room_for(count) }
    }

    /// Sorts by keys. No key may be greater than `most`; entries with equal keys come in any order. If the keys are
    /// evenly spread up to `most`, the time of the sort is proportional to the number of entries; otherwise it is the
    /// time of a sort by comparison.
    pub(crate) fn sort(&mut self, list: &mut [T], most: u64, key: impl Fn(&T) -> u64) {
        let SpreadSort { copy, starts } = self;
        let count = list.len() as u64;
        // Buckets per unit of key, in units of 2⁻⁶⁴. The ratio is less than 1, and the greatest key falls into the last
        // bucket.
        let share = ((u128::from(count) << 64) / (u128::from(most.max(count)) + 1)) as u64;
        let bucket = |entry: &T| ((u128::from(key(entry)) * u128::from(share)) >> 64) as usize;
        starts.clear();
        starts.resize(list.len(), 0);
        for entry in &*list {
            starts[bucket(entry)] += 1;
        }
        let mut so_far = 0;
        for end in &mut *starts {
            so_far += *end;
            *end = so_far;
        }
        copy.clear();
        copy.extend_from_slice(list);
        // Each bucket is filled from its end to its start.
        for entry in &*copy {
            let place = &mut starts[bucket(entry)];
            *place -= 1;
            list[*place as usize] = *entry;
        }
        let mut rest = list;
        for two in starts.windows(2) {
            let (own, others) = rest.split_at_mut((two[1] - two[0]) as usize);
            if own.len() > 1 {
                own.sort_unstable_by_key(&key);
            }
            rest = others;
        }
        if rest.len() > 1 {
            rest.sort_unstable_by_key(key);
        }
    }
}

#[cfg(test)]
mod tests {
    use alloc::vec::Vec;

    use super::SpreadSort;

    /// The keys are spread evenly, all in one bucket, all equal, and as large as possible.
    #[test]
    fn it_sorts_as_a_sort_by_comparison() {
        let mut state = 3_u64;
        let mut number = || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            state
        };
        let mut sort = SpreadSort::default();
        for count in [0, 1, 2, 3, 10, 300] {
            for (shift, most) in
                [(0, u64::MAX), (1, u64::MAX), (40, u64::MAX), (54, 1 << 10), (63, 1)]
            {
                let mut list: Vec<u64> = (0..count).map(|_| number() >> shift).collect();
                let mut sorted = list.clone();
                sorted.sort_unstable();
                sort.sort(&mut list, most, |&key| key);
                assert_eq!(list, sorted, "{count} {shift}");
            }
        }
    }
}
