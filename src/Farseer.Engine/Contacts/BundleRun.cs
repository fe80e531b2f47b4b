namespace Farseer.Engine.Contacts;

/// <summary>Bundles that lie behind each other, for a pass.</summary>
internal readonly unsafe struct BundleRun
{
    public readonly ContactBundle* Bundles;
    public readonly int Count;

    /// <summary>The run that comes next; of the last one itself.</summary>
    public readonly ContactBundle* Following;

    /// <summary>The rows come from memory: those ahead are to be asked for.</summary>
    public readonly bool IsFar;

    public BundleRun(ContactBundle* bundles, int count, ContactBundle* following, bool isFar)
    {
        Bundles = bundles;
        Count = count;
        Following = following;
        IsFar = isFar;
    }
}
