using System;
using Farseer.Engine.Numerics;
using Farseer.Engine.Storage;

namespace Farseer.Engine.Contacts;

/// <summary>
/// What the next step reads of the rows of contacts: who touches whom and what they bear. All else each narrow phase writes anew for every row
/// that is awake before anybody reads it, and it is more than half of a record. Rows that sleep are solved as they are when they wake.
/// </summary>
internal static unsafe class ContactRowState
{
    /// <summary>Writes, or reads, whole records.</summary>
    public static void Visit(StateStream s, ContactBundle* records, int count, bool areDormant)
    {
        for (int i = 0; i < count && !s.IsReading; i++)
        {
            // What the marks of a lane without a contact are depends on how many lanes are written at once, and is read by nobody.
            ContactLanes.RestMarks(records + i);
        }

        if (s.IsNaming)
        {
            VisitColumns(s, records, count, areDormant);
        }
        else if (areDormant)
        {
            s.Raw(records, (long)count * ContactBundle.Bytes);
        }
        else
        {
            VisitAwake(s, records, count);
        }

        for (int i = 0; i < count && s.IsReading && !areDormant; i++)
        {
            // Lanes beside the last bundle of a colour may be solved with it.
            for (int lane = 0; lane < ContactBundle.LineLanes; lane++)
            {
                if (records[i].Contact[lane] < 0)
                {
                    ContactLanes.Rest(records + i, lane);
                }
            }
        }
    }

    private static void VisitAwake(StateStream s, ContactBundle* records, int count)
    {
        for (ContactBundle* end = records + count; records < end; records++)
        {
            s.Raw(records->BodyA, (byte*)records->NormalX - (byte*)records->BodyA);
            VisitAwake(s, &records->Point0);
            VisitAwake(s, &records->Point1);
            s.Raw(records->Flags, (byte*)records->FeedRate - (byte*)records->Flags);
            s.Raw(records->Struck, (byte*)(records + 1) - (byte*)records->Struck);
        }
    }

    private static void VisitAwake(StateStream s, ContactPointLanes* point) => s.Raw(point->Normal, (byte*)(point + 1) - (byte*)point->Normal);

    /// <summary>The same column by column, each with its name, for those who look for a difference.</summary>
    private static void VisitColumns(StateStream s, ContactBundle* records, int count, bool areDormant)
    {
        for (ContactBundle* end = records + count; records < end; records++)
        {
            int* contacts = records->Contact;
            byte* column = (byte*)records;
            Numbers(s, ref column, contacts, nameof(ContactBundle.BodyA), nameof(ContactBundle.BodyB));
            Values(s, ref column, contacts, areDormant, nameof(ContactBundle.NormalX), nameof(ContactBundle.NormalY), nameof(ContactBundle.MassA),
                nameof(ContactBundle.MassB), nameof(ContactBundle.InertiaA), nameof(ContactBundle.InertiaB), nameof(ContactBundle.RadiusA),
                nameof(ContactBundle.RadiusB));
            VisitPoint(s, ref column, contacts, areDormant, nameof(ContactBundle.Point0));
            VisitPoint(s, ref column, contacts, areDormant, nameof(ContactBundle.Point1));
            Values(s, ref column, contacts, areDormant, nameof(ContactBundle.K11), nameof(ContactBundle.K22), nameof(ContactBundle.Friction));
            Numbers(s, ref column, contacts, nameof(ContactBundle.Flags));
            Values(s, ref column, contacts, areDormant, nameof(ContactBundle.FeedRate), nameof(ContactBundle.FeedShare), nameof(ContactBundle.Restitution));
            Values(s, ref column, contacts, true, nameof(ContactBundle.Struck));
            Numbers(s, ref column, contacts, nameof(ContactBundle.Contact), nameof(ContactBundle.PieceA), nameof(ContactBundle.PieceB),
                nameof(ContactBundle.Id0), nameof(ContactBundle.Id1), nameof(ContactBundle.Slot));
            if (column != (byte*)(records + 1))
            {
                throw new InvalidOperationException("The columns of a contact row are others than those that are named here.");
            }
        }
    }

    private static void VisitPoint(StateStream s, ref byte* column, int* contacts, bool areDormant, string point)
    {
        string from = point + ".";
        Values(s, ref column, contacts, areDormant, from + nameof(ContactPointLanes.NormalArmA), from + nameof(ContactPointLanes.TangentArmA),
            from + nameof(ContactPointLanes.NormalArmB), from + nameof(ContactPointLanes.TangentArmB), from + nameof(ContactPointLanes.Base));
        Values(s, ref column, contacts, true, from + nameof(ContactPointLanes.Normal), from + nameof(ContactPointLanes.Tangent),
            from + nameof(ContactPointLanes.Feed), from + nameof(ContactPointLanes.PreviousNormal), from + nameof(ContactPointLanes.PreviousTangent));
    }

    private static void Values(StateStream s, ref byte* column, int* contacts, bool areState, params string[] names)
    {
        foreach (string name in names)
        {
            if (areState)
            {
                s.Lanes((float*)column, contacts, ContactBundle.LineLanes, "Contact", name);
            }

            column += Prefetch.LineBytes;
        }
    }

    private static void Numbers(StateStream s, ref byte* column, int* contacts, params string[] names)
    {
        foreach (string name in names)
        {
            s.Lanes((int*)column, contacts, ContactBundle.LineLanes, "Contact", name);
            column += Prefetch.LineBytes;
        }
    }
}
