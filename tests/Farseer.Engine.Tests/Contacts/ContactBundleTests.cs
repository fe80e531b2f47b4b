using Farseer.Engine.Contacts;
using Xunit;

namespace Farseer.Engine.Tests.Contacts;

public sealed unsafe class ContactBundleTests
{
    [Fact]
    public void Bytes_OfABundle_AreItsSize() => Assert.Equal(sizeof(ContactBundle), ContactBundle.Bytes);

    [Fact]
    public void SolvedBytes_OfABundle_EndWhereItsContactsBegin()
    {
        ContactBundle bundle = default;
        Assert.Equal((byte*)bundle.Contact - (byte*)&bundle, ContactBundle.SolvedBytes);
    }
}
