using System;
using System.Collections.Generic;
using Farseer.Engine.Contacts;
using Farseer.Engine.Storage;
using Xunit;

namespace Farseer.Engine.Tests.Contacts;

public sealed unsafe class ContactBundleTests
{
    [Fact]
    public void Bytes_OfARecord_AreItsSize() => Assert.Equal(ContactBundle.Bytes, sizeof(ContactBundle));

    [Fact]
    public void Bundles_OneBehindTheOther_LieSideBySideInRecords()
    {
        const int Count = 9;
        var records = new Column<ContactBundle>(Count);
        ContactBundle* bundle = records.Pointer;
        var places = new HashSet<IntPtr>();
        for (int i = 0; i < Count; i++, bundle = ContactBundle.Next(bundle))
        {
            ContactBundle* record = records.Pointer + (i / ContactBundle.Beside);
            Assert.Equal((IntPtr)(record->BodyA + (i % ContactBundle.Beside * ContactBundle.Lanes)), (IntPtr)bundle->BodyA);
            Assert.Equal((IntPtr)(record->Slot + (i % ContactBundle.Beside * ContactBundle.Lanes)), (IntPtr)bundle->Slot);
            Assert.Equal(i % ContactBundle.Beside == 0, ContactBundle.IsFirst(bundle));
            Assert.True(places.Add((IntPtr)bundle));
            for (int steps = 0; steps < Count; steps++)
            {
                ContactBundle* other = ContactBundle.At(records.Pointer, i + steps);
                Assert.Equal((IntPtr)other, (IntPtr)ContactBundle.At(bundle, steps));
            }
        }
    }
}
