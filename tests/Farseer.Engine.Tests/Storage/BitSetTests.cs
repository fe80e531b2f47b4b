using System;
using System.Collections.Generic;
using Farseer.Engine.Storage;
using Xunit;

namespace Farseer.Engine.Tests.Storage;

public class BitSetTests
{
    [Fact]
    public void BitSet_UnderRandomUse_AgreesWithSortedSet()
    {
        var random = new Random(1);
        var set = new BitSet();
        var expected = new SortedSet<int>();
        for (int round = 0; round < 2000; round++)
        {
            int index = random.Next(1000);
            if (random.Next(2) == 0)
            {
                set.Set(index);
                expected.Add(index);
            }
            else
            {
                set.Clear(index);
                expected.Remove(index);
            }

            Assert.Equal(expected.Contains(index), set.Test(index));
        }

        var members = new List<int>();
        for (int i = set.Next(0); i >= 0; i = set.Next(i + 1))
        {
            members.Add(i);
        }

        Assert.Equal(expected, members);
        Assert.Equal(expected.Count, set.Count);
        set.ClearAll();
        Assert.Equal(-1, set.Next(0));
        set.Set(63);
        Assert.Equal(63, set.Next(0));
        Assert.Equal(-1, set.Next(64));
    }
}
